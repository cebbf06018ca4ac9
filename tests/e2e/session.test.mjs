// A page that is closed during a training: the next visit can bring back its work.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { bvh } from "./clips.mjs";
import { drop, openedSite, ready, revisit, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** The trainings of the page. */
const runs = (/** @type {Page} */ page) =>
  page.locator("pg-training").evaluate((view) =>
    /** @type {any} */ (view).training.runs.map((/** @type {any} */ run) => ({
      state: run.state,
      iterations: run.steps.at(-1)?.iteration ?? 0,
      bound: run.steps.at(-1)?.bound,
      text: run.model?.text,
    })),
  );

/** Enough to close the page during the training. */
const ITERATIONS = 400;
const SETTINGS = `tab=learn&trainings=1&iterations=${ITERATIONS}&fps=30&dynamics=16&poses=16`;

async function trained(/** @type {Page} */ page) {
  await page.getByTestId("train").waitFor({ timeout: 120_000 });
  const [run] = await runs(page);
  return run;
}

describe("a tab that is reloaded", () => {
  it("has its clips again by itself, without an offer", async () => {
    const { page } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    await drop(page, { "mine.bvh": bvh() });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await page.waitForFunction(() => /** @type {any} */ (document.querySelector("pg-page")).session !== null);
    await page.evaluate(() => /** @type {any} */ (document.querySelector("pg-page")).session.keepNow());
    await page.reload();
    await ready(page);
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    assert.equal(await page.getByTestId("earlier-visit").count(), 0);
  });
});

seldom.describe("a page that is closed in the middle of a training", () => {
  it("has its clips and training again at a press, and ends in the same model as one that was never closed", async () => {
    const { page } = await site.visit({ settings: SETTINGS });
    await ready(page);
    await drop(page, { "mine.bvh": bvh() });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    assert.equal(await page.getByTestId("earlier-visit").count(), 0);

    await page.getByTestId("train").click();
    const whole = await trained(page);
    assert.equal(whole.iterations, ITERATIONS);
    await page.locator("pg-training").evaluate((view) => /** @type {any} */ (view).training.clear());

    // The same again, and the page is closed during it. The model on the stage is in no list any more.
    await page.getByTestId("train").click();
    await page.getByTestId("unsaved-discard").click();
    await page.waitForFunction(() => {
      const { training } = /** @type {any} */ (document.querySelector("pg-training"));
      const isUnderWay = training.runs[0]?.steps.length > 10;
      if (isUnderWay) training.cancel();
      return isUnderWay;
    });
    await page.getByTestId("continue").waitFor();
    const [stopped] = await runs(page);
    assert.ok(stopped.iterations < ITERATIONS, `${stopped.iterations} iterations before it was cancelled`);
    await page.evaluate(() => /** @type {any} */ (document.querySelector("pg-page")).session.keepNow());
    await revisit(page);

    const offer = page.getByTestId("earlier-visit");
    await offer.waitFor();
    assert.match((await offer.textContent()) ?? "", /: a clip and a training\./);
    assert.equal(await page.getByTestId("own-clips").count(), 0, "nothing comes back by itself");
    await page.getByTestId("bring-back").click();
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await offer.waitFor({ state: "detached" });
    await page.getByTestId("continue").click();
    const ended = await trained(page);
    assert.equal(ended.iterations, ITERATIONS);
    assert.equal(ended.bound, whole.bound);
    // Only the seconds differ.
    const bare = (/** @type {string} */ text) => text.replace(/"seconds":[^,}]*/g, "");
    assert.equal(bare(ended.text), bare(whole.text));
  });

  it("is forgotten when the visitor says so, and comes back with Undo until the page is left", async () => {
    const { page, problems, leave } = await site.visit();
    await ready(page);
    await drop(page, { "mine.bvh": bvh() });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await page.getByTestId("forget").waitFor();
    await page.evaluate(() => /** @type {any} */ (document.querySelector("pg-page")).session.keepNow());
    await page.getByTestId("forget").click();
    await page.getByTestId("confirm-no").click();
    assert.equal(await page.getByTestId("undo-forget").count(), 0);
    const forget = async () => {
      await page.getByTestId("forget").focus();
      await page.keyboard.press("Enter");
      const question = page.getByTestId("confirm");
      await question.waitFor();
      assert.match(await question.innerText(), /removes a clip from this browser.* undo .* leave/s);
      await page.keyboard.press("Enter");
      await page.getByTestId("forgotten").filter({ hasText: "Forgotten: a clip." }).waitFor();
    };
    const offers = page.getByTestId("earlier-visit");
    const reload = async () => {
      await revisit(page);
      await page.getByTestId("forget").waitFor();
    };
    await forget();
    // The focus is on Undo, so that a press by mistake is undone with one more press.
    await page.keyboard.press("Enter");
    await page.getByTestId("forget").waitFor();
    await reload();
    assert.match((await offers.textContent()) ?? "", /: a clip\./);
    await page.getByTestId("bring-back").click();
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await forget();
    await reload();
    assert.equal(await offers.count(), 0);
    assert.deepEqual(problems, []);
    await leave();
  });
});
