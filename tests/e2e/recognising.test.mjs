// Which movement of a library clips show, below the controls of the large figure.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { opened } from "./library.mjs";
import { openSite, ready, resize } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

describe("clips on the view of primitives", () => {
  it("has its figure beside its controls only, not over what follows", async () => {
    const { page, leave } = await site.visit({ settings: "view=primitives" });
    await ready(page);
    await opened(page);
    for (const size of [
      { width: 1280, height: 800 },
      { width: 390, height: 844 },
    ]) {
      await resize(page, size);
      const edge = async (/** @type {string} */ place, /** @type {"top" | "bottom"} */ edge) =>
        page.locator(place).evaluate((element, edge) => element.getBoundingClientRect()[edge], edge);
      await page.getByTestId("add-primitives").scrollIntoViewIfNeeded();
      assert.ok((await edge(".walk-panel", "bottom")) > 0, "it is in sight beside the last control");
      for (const panel of [".recognition-panel", ".learning-panel"]) {
        await page.locator(panel).scrollIntoViewIfNeeded();
        assert.ok((await edge(".walk-panel", "bottom")) <= (await edge(".recognition-panel", "top")), panel);
      }
    }
    await leave();
  });

  it("says which movement three joined clips show, moment by moment", async () => {
    const { page, problems, leave } = await site.visit({ settings: "view=primitives", seen: true });
    await ready(page);
    await opened(page);
    const chosen = (/** @type {number} */ place) =>
      page
        .getByTestId(`recognise-${place}`)
        .evaluate((list) => /** @type {HTMLSelectElement} */ (list).selectedOptions[0]?.textContent?.trim());
    await page.waitForFunction(
      () =>
        /** @type {HTMLSelectElement} */ (document.querySelector("[data-testid=recognise-2]")).value !== "",
    );
    assert.deepEqual(await Promise.all([0, 1, 2].map(chosen)), [
      "Walk 1, by a model of CMU 35",
      "Jumping jacks 1, by a model of CMU",
      "Walk 2, by a model of CMU 35",
    ]);
    await page.getByTestId("recognise").click();
    const words = page.getByTestId("recognised");
    await words.waitFor({ timeout: 120_000 });
    assert.match(
      await words.innerText(),
      /^Walk from 0\.0 to [\d.]+ s, jump from [\d.]+ to [\d.]+ s, walk from /,
    );
    for (const part of [0, 1])
      assert.deepEqual(await page.locator(`[data-testid=bands-${part}] .band`).allInnerTexts(), [
        "walk",
        "jump",
        "walk",
      ]);
    const figure = page.locator(".recognised-figure");
    const first = await figure.screenshot();
    await page.getByRole("slider", { name: "Time", exact: true }).fill("120");
    assert.notDeepEqual(await figure.screenshot(), first, "the figure follows the time");
    await page.getByTestId("recognised-play").click();
    await page.waitForFunction(
      () => /** @type {any} */ (document.querySelector("pg-recognition")).recognition.player.frame > 121,
    );
    await page.getByTestId("recognise-1").selectOption("");
    assert.equal(await words.count(), 0);
    assert.deepEqual(problems, []);
    await leave();
  });
});
