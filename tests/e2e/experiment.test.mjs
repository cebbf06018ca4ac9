// The synthetic experiment: training in the browser, cancelling, several seeds.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, openedSite, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** Waits until the trainings have ended. */
const over = (/** @type {Page} */ page) => page.getByTestId("experiment-train").waitFor({ timeout: 240_000 });
const number = async (/** @type {Page} */ page, /** @type {string} */ id) =>
  Number((await page.getByTestId(id).innerText()).replaceAll(",", "").replace("\u2212", "-"));
/** Leaves the riddle with which the view begins, and waits until the experiment is drawn. */
async function chosen(/** @type {Page} */ page) {
  await page.getByTestId("riddle-none").click();
  await drawn(page);
}
/** Waits until the experiment is drawn. */
async function drawn(/** @type {Page} */ page) {
  await page.locator(".true-path[d^=M]").first().waitFor({ timeout: 30_000 });
}

describe("the synthetic experiment", () => {
  seldom.it("finds in the data of seed 0 that part 1 drives part 2, not the other way", async () => {
    const { page } = await site.visit({ settings: "view=synthetic", cores: 1 });
    await chosen(page);
    assert.equal(await page.locator(".curves-picture path").count(), 20, "ten curves of each part");
    assert.equal(await page.locator(".latent-picture .learned-path").count(), 0, "no learned path yet");
    await page.getByTestId("experiment-train").click();
    await over(page);
    assert.match(
      await page.getByTestId("experiment-verdict").innerText(),
      /^Found: part 1 drives part 2, and part 2 does not drive part 1\./,
    );
    const alpha = (/** @type {string} */ pair) => number(page, `experiment-alpha-${pair}`);
    assert.ok((await alpha("1-0")) >= 10 * (await alpha("0-0")), "part 2 has no influence on part 1");
    assert.ok((await alpha("0-1")) <= 4 * (await alpha("1-1")), "part 1 influences part 2");
    assert.ok((await number(page, "experiment-weight-0-1")) > 0.15);
    assert.equal(await page.getByTestId("experiment-weight-1-0").innerText(), "<0.01");
    assert.ok((await number(page, "experiment-bound")) > 3000);
    assert.ok((await number(page, "experiment-mse")) < 0.05);
    assert.equal(await page.locator(".latent-picture .learned-path").count(), 2);
    assert.equal(await page.getByTestId("experiment-run").count(), 1);
    assert.equal(await page.getByTestId("experiment-tally").innerText(), "Found with 1 of 1 seed.");
    assert.ok(
      await page.getByTestId("experiment-train").isDisabled(),
      "the same training would give the same result",
    );
    assert.deepEqual(await barriers(page), []);
  });

  it("begins with a riddle, and hides its truth until the visitor has voted and draws the curtain", async () => {
    const { page } = await site.visit({ settings: "view=synthetic", cores: 1 });
    await page.locator(".curves-picture path[d^=M]").first().waitFor({ timeout: 30_000 });
    assert.equal(await page.locator(".true-path").count(), 0, "the paths would tell");
    assert.equal(await page.getByTestId("experiment-driving").count(), 0);
    assert.doesNotMatch(await page.locator("pg-synthetic").innerText(), /part 2 does not drive|control/);
    assert.match(page.url(), /#view=synthetic$/);
    assert.deepEqual(await barriers(page), []);
    await page.getByTestId("riddle-yes").click();
    const curtain = page.getByTestId("riddle-curtain");
    await curtain.and(page.locator(":enabled")).waitFor({ timeout: 240_000 });
    assert.equal(await page.getByTestId("experiment-verdict").count(), 0);
    await curtain.click();
    const told = await page.getByTestId("riddle-told").innerText();
    const driving = await page.getByTestId("experiment-driving").isChecked();
    assert.match(
      told,
      driving
        ? /^The truth: Part 1 drives part 2. You were right\./
        : /^The truth: Neither .* You were wrong\./,
    );
    await page.getByTestId("experiment-verdict").waitFor();
    // Inside the model: for each part ten pairs of states before training and ten after it, and its curves.
    assert.equal(await page.locator(".snapshots .dynamics-point").count(), 40);
    assert.equal(await page.locator(".snapshots .mean-path[d^=M]").count(), 4);
    assert.equal(await page.locator(".snapshots .curves-box path").count(), 2 * 2 * 6);
    assert.deepEqual(await barriers(page), []);
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      page.getByTestId("experiment-save").click(),
    ]);
    assert.match(file.suggestedFilename(), /^synthetic-\d\.model\.json$/);
    await page.getByTestId("experiment-points-4").click();
    await page.waitForURL(/points=4/);
    await page.waitForFunction(() => document.querySelectorAll(".snapshots .dynamics-point").length === 8);
    await page.getByTestId("experiment-points-10").click();
    await page.getByTestId("experiment-series").click();
    await page.locator("pg-series pg-series-curves").waitFor();
  });

  seldom.it("keeps the best so far when it is cancelled, and does not count it", async () => {
    const { page } = await site.visit({
      settings: "view=synthetic&draw=9&driving=0",
      cores: 1,
    });
    await drawn(page);
    await page.getByTestId("experiment-ten").click();
    // The first of the ten trains, the others wait.
    await page
      .locator("[data-testid=experiment-run][data-state=running] td:nth-child(6)")
      .waitFor({ timeout: 30_000 });
    await page.getByTestId("experiment-cancel").click();
    await over(page);
    const rows = page.getByTestId("experiment-run");
    assert.equal(await rows.count(), 1, "trainings that had not begun are removed");
    assert.match(await rows.innerText(), /stopped early/);
    assert.equal(await page.getByTestId("experiment-tally").innerText(), "1 stopped early, not counted.");
    await page.getByRole("button", { name: "Look at seed 0 without driving" }).click();
    await drawn(page);
    assert.match(page.url(), /#view=synthetic&driving=0$/, "seed 0 is the default");
    assert.match(await page.getByTestId("experiment-verdict").innerText(), /Stopped after \d+ iterations/);
    assert.ok(Number.isFinite(await number(page, "experiment-bound")));
    assert.ok(await page.getByTestId("experiment-train").isEnabled(), "the training can continue");
  });

  seldom.it("limits the seed, and works by keyboard alone", async () => {
    const { page } = await site.visit({
      settings: "view=synthetic&draw=99999999999&driving=perhaps",
    });
    await drawn(page);
    const seed = page.getByTestId("experiment-seed");
    assert.equal(await seed.inputValue(), "4294967295");
    assert.ok(await page.getByTestId("experiment-driving").isChecked());
    const before = await page.locator(".true-path").first().getAttribute("d");
    await seed.focus();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("4");
    await page.keyboard.press("Tab");
    await page.waitForURL(/draw=4/);
    await page.waitForFunction(
      (before) =>
        document.querySelector(".true-path")?.getAttribute("d")?.startsWith("M") &&
        document.querySelector(".true-path")?.getAttribute("d") !== before,
      before,
    );
    await page.keyboard.press("Space");
    assert.ok(
      !(await page.getByTestId("experiment-driving").isChecked()),
      "the space bar belongs to the box, not to the stage",
    );
    // Back to the button, which keeps the focus while its text is Cancel.
    await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Enter");
    await page.locator("[data-testid=experiment-run] td:nth-child(6)").waitFor({ timeout: 30_000 });
    await page.getByTestId("experiment-cancel").waitFor();
    await page.keyboard.press("Enter");
    await over(page);
    assert.match(await page.getByTestId("experiment-run").innerText(), /stopped early/);
  });

  seldom.it("is accessible and fits on a phone", async () => {
    const { page } = await site.visit({
      settings: "view=synthetic",
      viewport: { width: 390, height: 844 },
      hasTouch: true,
      isMobile: true,
    });
    await chosen(page);
    await page.getByTestId("experiment-train").click();
    await page.locator("[data-testid=experiment-run] td:nth-child(6)").waitFor({ timeout: 30_000 });
    await page.getByTestId("experiment-cancel").click();
    await over(page);
    assert.deepEqual(await barriers(page), []);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} pixels wide`);
  });
});
