// Several trainings at once: a worker for each, their table, the best on the stage, a cancel and a crash.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { Model } from "../../crate/wasm/pkg/node/vcgpdm.js";
import { LONG, barriers, openPanel, openedSite, ready, saved, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** A visit on a machine with this number of cores, as the page sees it. */
async function visit(/** @type {number} */ cores, /** @type {string} */ settings, options = {}) {
  const visit = await site.visit({ settings: `tab=learn&${settings}`, cores, ...options });
  await ready(visit.page);
  return visit;
}

/** Records the most trainings that ever run at once. */
async function watchRunning(/** @type {Page} */ page) {
  await page.evaluate(() => {
    Object.assign(window, { mostRunning: 0 });
    new MutationObserver(() => {
      const now = document.querySelectorAll("[data-testid=run][data-state=running]").length;
      Object.assign(window, { mostRunning: Math.max(now, /** @type {any} */ (window).mostRunning) });
    }).observe(document.body, { subtree: true, childList: true, attributes: true });
  });
  return () => page.evaluate(() => Number(/** @type {any} */ (window).mostRunning));
}

const trainIsBack = (/** @type {Page} */ page) => page.getByTestId("train").waitFor({ timeout: 120_000 });
const provenance = async (/** @type {Page} */ page) =>
  Model.fromJson((await saved(page, "save-model")).text).info().provenance;

/** The texts of the table. */
async function table(/** @type {Page} */ page) {
  return page.getByTestId("run").evaluateAll((rows) =>
    rows.map((row) => ({
      state: /** @type {HTMLElement} */ (row).dataset.state,
      seed: Number(row.querySelector("th")?.textContent),
      chosen: row.querySelector("input")?.checked,
      best: row.querySelector(".best") !== null,
      cells: [...row.querySelectorAll("td")].map(
        (cell) => cell.textContent?.replace(", the best", "").trim() ?? "",
      ),
    })),
  );
}

/**
 * The place of the run that the page has to show: of those whose motions end best, the one whose rollouts
 * repeat the clips with the smallest error.
 */
async function placeToShow(/** @type {Page} */ page) {
  const judged = await page.locator("pg-runs").evaluate((view) =>
    /** @type {any} */ (view).training.runs.map((/** @type {any} */ { model }) => ({
      rank: Number(model?.health?.rank ?? 0),
      error: Number(model?.error ?? Number.POSITIVE_INFINITY),
    })),
  );
  const known = judged.filter((/** @type {{ error: number }} */ { error }) => Number.isFinite(error));
  assert.ok(known.length > 0 && known.every((/** @type {{ error: number }} */ { error }) => error > 0));
  const [best] = [...judged].sort((a, b) => b.rank - a.rank || a.error - b.error);
  return judged.indexOf(best);
}

/** Waits until the row of this seed is marked, and returns the seed of the model that the page then saves. */
async function seedShown(/** @type {Page} */ page, /** @type {number} */ seed) {
  await page.waitForFunction(
    (seed) => document.querySelector("[data-testid=run].chosen th")?.textContent?.trim() === String(seed),
    seed,
  );
  return (await provenance(page)).settings.seed;
}

describe("several trainings", () => {
  it("run on their own workers, and the best is on the stage; a click shows another", async () => {
    const { page } = await visit(3, "trainings=3&seed=5&iterations=60&fps=15");
    const before = page.workers().length;
    const most = await watchRunning(page);
    let workers = 0;
    page.on("worker", () => {
      workers += 1;
    });
    await page.getByTestId("train").click();
    await trainIsBack(page);
    assert.equal(before, 1, "no worker of the pool starts before there is work");
    assert.equal(workers, 3);
    assert.ok((await most()) >= 2, `${await most()} trainings at once`);

    const rows = await table(page);
    assert.deepEqual(
      rows.map(({ seed }) => seed),
      [5, 6, 7],
    );
    assert.deepEqual(
      rows.map(({ state }) => state),
      ["done", "done", "done"],
    );
    const bounds = rows.map(({ cells }) => Number(cells[0]?.replace(/,/g, "").replace("\u2212", "-")));
    assert.ok(bounds.every(Number.isFinite) && new Set(bounds).size === 3, `bounds ${bounds}`);
    const highest = bounds.indexOf(Math.max(...bounds));
    assert.deepEqual(
      rows.map(({ best }) => best),
      bounds.map((_, i) => i === highest),
    );
    // Not the highest bound decides, but the motion: whether it goes on, and how close it is to the clips.
    const at = await placeToShow(page);
    assert.deepEqual(
      rows.map(({ chosen }) => chosen),
      bounds.map((_, i) => i === at),
    );
    const shown = await provenance(page);
    assert.equal(shown.settings.seed, 5 + at);
    assert.equal(Math.round(shown.objective), bounds[at]);

    const other = (at + 1) % 3;
    await page.getByTestId("run").nth(other).click();
    assert.equal(await seedShown(page, 5 + other), 5 + other);
    // The arrow keys go to the next one.
    await page.getByTestId("run").nth(other).getByRole("radio").focus();
    await page.keyboard.press("ArrowDown");
    const next = (other + 1) % 3;
    assert.equal(await seedShown(page, 5 + next), 5 + next);
  });

  seldom.it("wait for their turn on a machine with one core", async () => {
    const { page } = await visit(1, "trainings=3&iterations=10&fps=15");
    const most = await watchRunning(page);
    await page.getByTestId("train").click();
    await trainIsBack(page);
    assert.equal(await most(), 1);
    assert.deepEqual(
      (await table(page)).map(({ state }) => state),
      ["done", "done", "done"],
    );
  });

  seldom.it("keep finished and best models when they are cancelled", async () => {
    const { page } = await visit(2, "trainings=4&iterations=150&fps=30");
    await page.getByTestId("train").click();
    await page.locator("[data-testid=run][data-state=done]").first().waitFor({ timeout: 90_000 });
    await page.locator("[data-testid=run][data-state=running]").first().waitFor({ timeout: 30_000 });
    await page.getByTestId("cancel").click();
    await trainIsBack(page);
    const rows = await table(page);
    const done = rows.filter(({ state }) => state === "done");
    assert.ok(done.length >= 1 && done.length < 4, JSON.stringify(rows));
    assert.ok(
      rows.every(({ state }) => state === "done" || state === "cancelled"),
      JSON.stringify(rows),
    );
    const chosen = rows.filter(({ chosen }) => chosen);
    assert.equal(chosen.length, 1);
    assert.equal(
      rows.findIndex(({ chosen }) => chosen),
      await placeToShow(page),
      JSON.stringify(rows),
    );
    assert.equal((await provenance(page)).settings.seed, chosen[0]?.seed);
  });

  seldom.it("continue when the worker of one of them dies", async () => {
    const { page, leave } = await visit(2, "trainings=3&iterations=150&fps=30");
    /** @type {import("playwright-core").Worker[]} */
    const workers = [];
    page.on("worker", (worker) => workers.push(worker));
    await page.getByTestId("train").click();
    await page.waitForFunction(
      () => Number(document.querySelector("[data-testid=run] td:nth-of-type(2)")?.textContent) > 2,
    );
    await workers[0]?.evaluate(() => {
      setTimeout(() => {
        throw new Error("a test broke this worker");
      });
    });
    await trainIsBack(page);
    const rows = await table(page);
    assert.deepEqual(rows.map(({ state }) => state).sort(), ["done", "done", "failed"], JSON.stringify(rows));
    await page.getByTestId("runs").getByText("a test broke this worker").waitFor();
    assert.equal(workers.length, 3, "a fresh worker took the place of the one that died");
    const chosen = rows.find(({ chosen }) => chosen);
    assert.equal(chosen?.state, "done");
    assert.equal((await provenance(page)).settings.seed, chosen?.seed);
    await leave();
  });

  seldom.it("run side by side with different settings", async () => {
    const { page } = await visit(2, "trainings=1&iterations=4000&fps=60");
    const most = await watchRunning(page);
    await page.getByTestId("train").click();
    await page.getByTestId("setting-dynamicsIps").fill("8");
    await page.getByTestId("setting-dynamicsIps").press("Enter");
    await page.getByTestId("add").click();
    // Both have a bound, so that there is a best.
    await page.waitForFunction(() => {
      const { runs } = /** @type {any} */ (document.querySelector("pg-training")).training;
      return runs.length === 2 && runs.every((/** @type {any} */ run) => run.steps.length > 0);
    });
    await page.getByTestId("cancel").click();
    await trainIsBack(page);
    assert.equal(await most(), 2);
    // The page knows the best when both models have arrived.
    await page.waitForFunction(() => document.querySelector("[data-testid=run] .best") !== null);
    const rows = await table(page);
    assert.deepEqual(
      rows.map(({ state }) => state),
      ["cancelled", "cancelled"],
      JSON.stringify(rows),
    );
    // The first cell is the setting in which they differ. Other cells, as the iterations, may equal it by chance.
    assert.deepEqual(
      rows.map(({ cells }) => cells[0]),
      ["12", "8"],
      JSON.stringify(rows),
    );
    assert.equal(rows.filter(({ best }) => best).length, 1);
  });

  seldom.it("do not block the sliders", async () => {
    const { page } = await visit(2, `trainings=2&${LONG}`);
    await page.getByTestId("train").click();
    await page.waitForFunction(
      () => Number(document.querySelector("[data-testid=run] td:nth-of-type(2)")?.textContent) > 2,
    );
    const weight = page.getByTestId("weight-0-1");
    const before = await weight.textContent();
    await page.getByTestId("coupling-0-1").fill("2.5");
    await page.waitForFunction(
      (before) => document.querySelector("[data-testid=weight-0-1]")?.textContent !== before,
      before,
      { timeout: 5000 },
    );
    await openPanel(page, "learn");
    assert.equal(await page.getByTestId("cancel").count(), 1, "it still trains");
    await page.getByTestId("cancel").click();
    await trainIsBack(page);
  });
});

describe("the table of trainings", () => {
  seldom.it(
    "keeps trainings with different settings, shows the differences, and can be cleared",
    async () => {
      const { page } = await visit(2, "trainings=1&iterations=10&fps=15");
      await page.getByTestId("train").click();
      await page.locator("[data-testid=run][data-state=done]").waitFor({ timeout: 90_000 });
      await trainIsBack(page);
      await page.getByTestId("setting-dynamicsIps").fill("9");
      await page.getByTestId("setting-dynamicsIps").blur();
      await page.getByTestId("train").click();
      await page.locator("[data-testid=run][data-state=done]").nth(1).waitFor({ timeout: 90_000 });
      await trainIsBack(page);
      const heads = await page.getByTestId("runs").locator("thead th").allTextContents();
      assert.deepEqual(heads, ["Seed", "K", "Objective", "It.", "Time"]);
      assert.deepEqual(
        (await table(page)).map(({ cells }) => cells[0]),
        ["12", "9"],
      );

      const shown = await provenance(page);
      await page.getByRole("button", { name: "Remove seed 0" }).first().click();
      assert.equal(await page.getByTestId("run").count(), 1);
      await page.getByTestId("clear-runs").click();
      assert.equal(await page.getByTestId("run").count(), 0);
      assert.deepEqual(await provenance(page), shown, "the model stays on the stage");
    },
  );

  seldom.it("has no serious barrier, and fits a phone", async () => {
    const { page, leave } = await visit(2, "trainings=2&iterations=10&fps=15", {
      viewport: { width: 390, height: 844 },
    });
    await page.getByTestId("train").click();
    await trainIsBack(page);
    assert.deepEqual(await barriers(page), []);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
    await leave();
  });
});
