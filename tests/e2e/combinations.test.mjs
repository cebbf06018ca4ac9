// Combinations of primitives: their couplings, the stage, and the figure next to the controls.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { openedSite, ready, resize, seldom } from "./site.mjs";
import { opened } from "./library.mjs";

const site = openedSite();

describe("a combination of primitives", () => {
  seldom.it("fits arms of a jumping jack beside legs of a walk to a walk, and undoes it", async () => {
    const { page } = await site.visit({ settings: "view=primitives" });
    await ready(page);
    await page.getByTestId("combination").first().waitFor({ timeout: 30_000 });
    const [legs, arms] = [page.getByTestId("walk-alpha-0-1"), page.getByTestId("walk-alpha-1-1")];
    const before = await arms.innerText();
    assert.equal(await legs.innerText(), "10.0", "parts that never met hardly listen");
    await page.getByTestId("fit-clip").selectOption({ label: "Walk 1, by a model of CMU 35" });
    await page.getByTestId("fit").click();
    await page.getByTestId("fit-words").filter({ hasText: / s\.$/ }).waitFor({ timeout: 60_000 });
    const fitted = await Promise.all([legs, arms].map((alpha) => alpha.innerText()));
    assert.ok(Number(fitted[0]) < 0.01 && Number(fitted[1]) > 0.5, fitted.join());
    await page.locator("pg-walk-couplings").getByRole("button", { name: "Reset", exact: true }).click();
    assert.deepEqual([await legs.innerText(), await arms.innerText()], ["10.0", before]);
  });

  seldom.it("asks for saving only before a combination is lost that no file has", async () => {
    const { page } = await site.visit({ settings: "view=primitives" });
    await ready(page);
    await page.getByTestId("combination").first().waitFor({ timeout: 30_000 });
    const stage = () => page.getByTestId("put-on-stage").click();
    const back = async () => {
      await page.getByTestId("stage").waitFor();
      await page.getByTestId("view-primitives").click();
      await page.getByTestId("combination-title").waitFor();
    };
    // The library of the page is safe, and so are its combinations.
    for (const nth of [0, 1, 2]) {
      await page.getByTestId("combination").nth(nth).click();
      await stage();
      await back();
    }
    await page.getByTestId("walk-coupling-0-1").press("ArrowLeft");
    await stage();
    await back();
    // Couplings set by hand are in no file.
    await stage();
    await page.getByTestId("unsaved-keep").click();
  });

  it("keeps the figure in view next to the tempos and the combinations", async () => {
    const { page, leave } = await site.visit({
      settings: "view=primitives",
      viewport: { width: 1280, height: 720 },
    });
    await page.getByTestId("combination").first().waitFor({ timeout: 30_000 });
    for (const id of ["tempo-1", "fit"]) {
      await page.getByTestId(id).scrollIntoViewIfNeeded();
      const visible = await page.getByTestId("walk").evaluate((figure) => {
        const { top, bottom, height } = figure.getBoundingClientRect();
        return (Math.min(bottom, innerHeight) - Math.max(top, 0)) / height;
      });
      assert.ok(visible > 0.9, `${visible} of the figure is in view next to ${id}`);
    }
    await leave();
  });
});

// Which movement of a library clips show, below the controls of the large figure.

describe("clips on the view of primitives", () => {
  seldom.it("has its figure beside its controls only, not over what follows", async () => {
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

  seldom.it("says which movement three joined clips show, moment by moment", async () => {
    const { page } = await site.visit({ settings: "view=primitives", seen: true });
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
  });
});
