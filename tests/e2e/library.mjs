// The view of primitives, as several tests use it.

/** @typedef {import("playwright-core").Page} Page */

/** Waits until the library is open and all small figures have their motion. */
export async function opened(/** @type {Page} */ page) {
  await page.getByTestId("combination").first().waitFor({ timeout: 30_000 });
  await page.waitForFunction(
    () => {
      const figures = [...document.querySelectorAll("pg-small-figure")];
      return figures.length > 0 && figures.every((figure) => /** @type {any} */ (figure).motion);
    },
    null,
    { timeout: 30_000 },
  );
}
