// The built page in a real browser, served from a sub-folder as a university's web space would.
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { dist } from "../../scripts/site.mjs";

/** @typedef {import("playwright-core").Page} Page */

/**
 * @param {object} [options]
 * @param {string} [options.folder] the built page
 * @param {(path: string) => unknown} [options.before] may hold back a file until its promise is kept
 * @param {(path: string, bytes: number) => void} [options.onSend] told of each file sent
 */
export async function openSite({ folder = dist, ...options } = {}) {
  const server = await serve(folder, { prefix: "/some/where/", ...options });
  const browser = await launchChromium();

  /**
   * A fresh visitor on the page, and what went wrong while they were there.
   * @param {import("playwright-core").BrowserContextOptions & { settings?: string, cores?: number, moving?: boolean }} [options]
   *   `settings` as in the page's address; `cores`: as many as the page shall believe the machine to have; `moving`: whether the
   *   figure walks from the beginning, which costs a core where no graphics card draws; a visitor who wants little motion else
   */
  async function visit({ settings = "", cores = 0, moving = false, ...options } = {}) {
    /** @type {import("playwright-core").BrowserContextOptions} */
    const usual = {
      viewport: { width: 1280, height: 800 },
      reducedMotion: moving ? "no-preference" : "reduce",
      // With a service worker the files come from there: only its own test wants that.
      serviceWorkers: "block",
    };
    const context = await browser.newContext({ ...usual, ...options });
    const page = await context.newPage();
    if (cores > 0)
      await page.addInitScript(
        (cores) => Object.defineProperty(navigator, "hardwareConcurrency", { get: () => cores }),
        cores,
      );
    /** @type {string[]} */
    const problems = [];
    page.on("console", (message) => message.type() === "error" && problems.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
    page.on("requestfailed", (request) => problems.push(`failed: ${request.url()} ${request.failure()?.errorText}`));
    context.on("request", (request) => {
      if (/^https?:/.test(request.url()) && !request.url().startsWith(server.address))
        problems.push(`foreign: ${request.url()}`);
    });
    await page.goto(`${server.address}#${settings}`);
    return { page, problems, leave: () => context.close() };
  }

  return {
    visit,
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/** Waits until the wasm runs and the sample clips are there: nothing is dead any more. */
export async function ready(/** @type {Page} */ page) {
  await page.waitForSelector("html[data-engine=ready], html[data-engine=failed]", { timeout: 30_000 });
  await page.getByTestId("train").and(page.locator(":enabled")).waitFor({ state: "attached", timeout: 30_000 });
}

/** Whether what an element shows differs between two moments. */
export async function changes(/** @type {import("playwright-core").Locator} */ element, milliseconds = 400) {
  const before = await element.screenshot();
  await element.page().waitForTimeout(milliseconds);
  return !before.equals(await element.screenshot());
}

/** Whether what an element shows comes to rest (the camera may still glide a little, the picture get finer). */
export async function rests(/** @type {import("playwright-core").Locator} */ element) {
  for (let i = 0; i < 10; i++) if (!(await changes(element))) return true;
  return false;
}

/** What a button saves to disk; those of the menu of the page's head are opened first. */
export async function saved(/** @type {Page} */ page, /** @type {string} */ button) {
  if (await page.locator(`#save-menu [data-testid=${button}]`).count()) await page.getByTestId("save").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), "utf8") };
}

/** Drops files onto the middle of the page, as from a file manager. */
export async function drop(/** @type {Page} */ page, /** @type {Record<string, string>} */ files) {
  const dataTransfer = await page.evaluateHandle((files) => {
    const transfer = new DataTransfer();
    for (const [name, text] of Object.entries(files)) transfer.items.add(new File([text], name));
    return transfer;
  }, files);
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.dispatchEvent("body", type, { dataTransfer, clientX: 640, clientY: 400 });
  }
}

const axe = readFileSync(at("node_modules/axe-core/axe.min.js"), "utf8");

/** What axe-core finds that keeps somebody out; `rules`: by these rules alone, some of which it does not ask unless told to. */
export async function barriers(/** @type {Page} */ page, /** @type {string[]} */ rules = []) {
  await page.evaluate(axe);
  return page.evaluate(async (rules) => {
    const options = rules.length > 0 ? { runOnly: { type: "rule", values: rules } } : {};
    const { violations } = await /** @type {any} */ (globalThis).axe.run(options);
    return /** @type {import("axe-core").Result[]} */ (violations)
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")}: ${failureSummary}`),
      );
  }, rules);
}
