// Workers that die.
import assert from "node:assert/strict";
import { it } from "node:test";
import { setTimeout } from "node:timers/promises";
import { bvh } from "./clips.mjs";
import { drop, isMeasured, openPanel, openedSite, ready, saved, seldom, soon } from "./site.mjs";

const site = openedSite();

/** @typedef {import("playwright-core").Worker} Worker */

/** Playwright waits without end for the answer of a worker that has just closed. */
const ANSWER = 3000;
const nameOf = (/** @type {Worker} */ worker) =>
  Promise.race([worker.evaluate(() => self.name).catch(() => ""), setTimeout(ANSWER, "")]);
/** The worker closes itself: no event tells the page. */
const close = (/** @type {Worker | undefined} */ worker) =>
  Promise.race([worker?.evaluate(() => self.close()).catch(() => {}), setTimeout(ANSWER)]);

seldom.describe("the worker that shows the model", () => {
  it("is started again when it dies silently, with the same model", async () => {
    const { page } = await site.visit();
    await ready(page);
    const model = await saved(page, "save-model");
    await page.getByTestId("coupling-0-1").fill("1.5");
    await isMeasured(page);
    const motion = await saved(page, "save-motion");

    const names = await Promise.all(page.workers().map(nameOf));
    const shows = page.workers()[names.findIndex((name) => name.includes("model"))];
    await close(shows);
    await page.getByText("The program was started again").waitFor({ timeout: 5000 });
    assert.deepEqual(await saved(page, "save-model"), model);
    assert.deepEqual(await saved(page, "save-motion"), motion);
    await page.getByTestId("coupling-0-1").fill("2.5");
    await isMeasured(page);
    assert.notEqual((await saved(page, "save-motion")).text, motion.text);
    // A clip is written by another worker.
    await openPanel(page, "learn");
    await page.getByText("Samples, made by a program").click();
    await page
      .getByRole("button", { name: /^Show / })
      .first()
      .click();
    assert.match((await saved(page, "save-motion")).text, /^HIERARCHY/);
  });
});

seldom.describe("a worker that takes over", () => {
  /** A visit whose replacements die when they open the model again: the first of them, this many. */
  const visitWith = async (/** @type {number} */ deaths) => {
    const { page, ...rest } = await site.visit();
    await page.addInitScript((deaths) => {
      let models = 0;
      const Real = Worker;
      window.Worker = class extends Real {
        #dies = false;
        /** @param {string | URL} url @param {WorkerOptions} [options] */
        constructor(url, options) {
          super(url, options);
          if (!options?.name?.includes("model")) return;
          models += 1;
          this.#dies = models > 1 && models <= 1 + deaths;
        }
        /** @param {any} message @param {any} transfer */
        postMessage(message, transfer) {
          if (this.#dies && String(message?.path) === "openModel") this.terminate();
          else super.postMessage(message, transfer);
        }
      };
    }, deaths);
    await page.reload();
    await ready(page);
    return { page, ...rest };
  };
  const kill = async (/** @type {import("playwright-core").Page} */ page) => {
    for (const worker of page.workers()) if ((await nameOf(worker)).includes("model")) await close(worker);
  };

  it("is replaced when it dies too", async () => {
    const { page } = await visitWith(1);
    const model = await saved(page, "save-model");
    await kill(page);
    await page.getByText("The program was started again").waitFor({ timeout: 10_000 });
    assert.deepEqual(await saved(page, "save-model"), model);
  });

  it("is given up after three failures, and the page keeps everything over a reload", async () => {
    const { page, leave } = await visitWith(3);
    await drop(page, { "mine.bvh": bvh() });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await kill(page);
    await page.getByTestId("stopped").getByRole("button").click({ timeout: 20_000 });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await leave();
  });
});

seldom.describe("a worker that trains", () => {
  it("fails its training when it dies silently, and the other trainings finish", async () => {
    const { page } = await site.visit({
      settings: "tab=learn&trainings=2&iterations=150&fps=60",
      cores: 2,
    });
    await ready(page);
    /** @type {import("playwright-core").Worker[]} */
    const workers = [];
    page.on("worker", (worker) => workers.push(worker));
    await page.getByTestId("train").click();
    await page.locator("[data-testid=run][data-state=running]").nth(1).waitFor();
    const computed = page.locator("[data-testid=run] progress").first();
    await soon(async () =>
      assert.ok((await computed.evaluate((bar) => /** @type {HTMLProgressElement} */ (bar).value)) > 0),
    );
    await close(workers[0]);
    await page.locator("[data-testid=run][data-state=failed]").waitFor({ timeout: 5000 });
    await page.getByTestId("runs").getByText("the worker that computed it stopped").waitFor();
    await page.locator("[data-testid=run][data-state=done]").waitFor({ timeout: 90_000 });
  });
});
