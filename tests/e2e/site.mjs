// The built page in a real browser, served from a sub-folder as a university's web space would.
import { launchChromium } from "../../scripts/chromium.mjs";
import { serve } from "../../scripts/serve.mjs";
import { dist } from "../../scripts/site.mjs";

/**
 * @param {object} [options]
 * @param {(path: string) => unknown} [options.before] may hold back a file until its promise is kept
 * @param {(path: string, bytes: number) => void} [options.onSend] told of each file sent
 */
export async function openSite(options = {}) {
  const server = await serve(dist, { prefix: "/some/where/", ...options });
  const browser = await launchChromium();

  /**
   * A fresh visitor on the page, and what went wrong while they were there.
   * @param {import("playwright-core").BrowserContextOptions & { query?: string }} [options]
   */
  async function visit({ query = "", ...options } = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    const page = await context.newPage();
    /** @type {string[]} */
    const problems = [];
    page.on("console", (message) => message.type() === "error" && problems.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
    page.on("requestfailed", (request) => problems.push(`failed: ${request.url()} ${request.failure()?.errorText}`));
    context.on("request", (request) => {
      if (/^https?:/.test(request.url()) && !request.url().startsWith(server.address)) problems.push(`foreign: ${request.url()}`);
    });
    await page.goto(server.address + query);
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

/** Waits until the wasm has loaded and the page is fully usable. */
export const ready = (/** @type {import("playwright-core").Page} */ page) => page.waitForSelector("html[data-engine=ready]", { timeout: 30_000 });

/** Whether what an element shows differs between two moments. */
export async function changes(/** @type {import("playwright-core").Locator} */ element, milliseconds = 400) {
  const before = await element.screenshot();
  await element.page().waitForTimeout(milliseconds);
  return !before.equals(await element.screenshot());
}
