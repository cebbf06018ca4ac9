// The built page in a real browser, served from a sub-folder as a university's web space would.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { after, before, it } from "node:test";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { dist } from "../../scripts/site.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** Pictures a second of a slow display. */
const PICTURES = 12;

/**
 * Runs in the page: a walking figure takes a core and more where no graphics card draws, unless pictures are
 * few.
 */
function slowDisplay(/** @type {number} */ pictures) {
  const ask = requestAnimationFrame.bind(window);
  /** @type {Map<number, FrameRequestCallback>} */
  let asked = new Map();
  let newest = 0;
  let last = 0;
  const show = (/** @type {number} */ now) => {
    // Not a little later than it must be, or one more picture is left out.
    if (now - last < 1000 / pictures - 8) return void ask(show);
    last = now;
    const all = asked;
    asked = new Map();
    for (const each of all.values()) each(now);
  };
  window.requestAnimationFrame = (each) => {
    if (asked.size === 0) ask(show);
    asked.set(++newest, each);
    return newest;
  };
  window.cancelAnimationFrame = (which) => void asked.delete(which);
}

/** Runs in the page: all is computed and handed to the graphics card, which draws nothing. */
function noDrawing() {
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
    for (const draw of ["drawArrays", "drawArraysInstanced", "drawElements", "drawElementsInstanced"])
      if (draw in prototype) Object.assign(prototype, { [draw]() {} });
}

/** Runs in the page: counts for each canvas how many times it was cleared, which three.js does once a scene. */
function countPictures() {
  const times = new WeakMap();
  const { prototype } = WebGL2RenderingContext;
  const { clear } = prototype;
  prototype.clear = function (mask) {
    // Shadows are drawn into a framebuffer.
    const isCanvas = this.getParameter(this.FRAMEBUFFER_BINDING) === null;
    if (isCanvas) times.set(this.canvas, (times.get(this.canvas) ?? 0) + 1);
    clear.call(this, mask);
  };
  Object.assign(window, { timesCleared: times });
}

/**
 * @typedef {object} Visit
 * @property {string} [settings] as in the page's address
 * @property {string} [query] as well
 * @property {number} [cores] as many as the page shall believe the machine to have
 * @property {boolean} [moving] whether the figure walks from the beginning, on a slow display; a visitor who
 * wants little motion else
 * @property {number} [pictures] of the slow display, a second
 * @property {boolean} [seen] whether figures are drawn, which takes long without a graphics card
 * @property {boolean} [idle] whether the whole program comes when the page has nothing else to do; else when
 * it is needed
 * @property {string} [without] files that do not come
 */

/**
 * @param {object} [options]
 * @param {string} [options.folder] the built page
 * @param {string[]} [options.flags] of the browser
 * @param {(path: string) => unknown} [options.before] may hold back a file until its promise is kept
 * @param {(path: string, bytes: number) => void} [options.onSend] told of each file sent
 */
export async function openSite({ folder = dist, flags = /** @type {string[]} */ ([]), ...options } = {}) {
  const server = await serve(folder, { prefix: "/some/where/", ...options });
  const browser = await launchChromium(flags);

  /** A fresh visitor on the page, and what went wrong while they were there. @param {import("playwright-core").BrowserContextOptions & Visit} [options] */
  async function visit({
    settings = "",
    query = "",
    cores = 0,
    moving = false,
    pictures = PICTURES,
    seen = false,
    idle = false,
    without = "",
    ...options
  } = {}) {
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
    if (moving) await context.addInitScript(slowDisplay, pictures);
    await context.addInitScript(countPictures);
    if (!seen) await context.addInitScript(noDrawing);
    if (!idle)
      await context.addInitScript(() =>
        Object.defineProperty(navigator, "connection", { get: () => ({ saveData: true }) }),
      );
    /** @type {string[]} */
    const problems = [];
    page.on(
      "console",
      (message) => message.type() === "error" && problems.push(`console: ${message.text()}`),
    );
    page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
    page.on("requestfailed", (request) => {
      const why = request.failure()?.errorText;
      // What is still on its way when a page is left is given up.
      if (why !== "net::ERR_ABORTED") problems.push(`failed: ${request.url()} ${why}`);
    });
    context.on("request", (request) => {
      if (/^https?:/.test(request.url()) && !request.url().startsWith(server.address))
        problems.push(`foreign: ${request.url()}`);
    });
    if (without) await page.route(without, (route) => route.abort());
    await page.goto(`${server.address}${query}#${settings}`);
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

/** Settings of a training that goes on long after a test has looked at it. */
export const LONG = "iterations=5000&dynamics=24&poses=24";

/** Waits until the wasm runs and the sample clips are there: nothing is dead any more. */
export async function ready(/** @type {Page} */ page) {
  await page.waitForSelector("html[data-engine=ready], html[data-engine=failed]", { timeout: 30_000 });
  await page
    .getByTestId("train")
    .and(page.locator(":enabled"))
    .waitFor({ state: "attached", timeout: 30_000 });
}

/** Whether what an element shows differs between two moments. */
export async function changes(/** @type {import("playwright-core").Locator} */ element, milliseconds = 400) {
  const before = await element.screenshot();
  await element.page().waitForTimeout(milliseconds);
  return !before.equals(await element.screenshot());
}

/** How many pictures of its figures a canvas has shown. */
export const pictures = (/** @type {import("playwright-core").Locator} */ canvas) =>
  canvas.evaluate((canvas) => Number(/** @type {any} */ (window).timesCleared.get(canvas) ?? 0));

/** Waits until a canvas has shown three more pictures of its figures. */
export async function draws(/** @type {import("playwright-core").Locator} */ canvas) {
  const end = (await pictures(canvas)) + 3;
  while ((await pictures(canvas)) < end) await canvas.page().waitForTimeout(50);
}

/**
 * Whether what an element shows comes to rest (the camera may still glide a little, the picture get finer).
 */
export async function rests(/** @type {import("playwright-core").Locator} */ element) {
  for (let i = 0; i < 10; i++) if (!(await changes(element))) return true;
  return false;
}

const SCREENS = [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
];

/** @typedef {{ page: Page, problems: string[], leave: () => Promise<void> }} Visitor */

/**
 * Tests of a view on a desk and a phone: `look` goes through it, and nothing is wider than the screen.
 * @param {(options: { viewport: { width: number, height: number } }) => Promise<Visitor>} visit
 * @param {(page: Page) => Promise<void>} look
 */
export function keepsNobodyOut(visit, look) {
  for (const viewport of SCREENS) {
    it(`keeps nobody out, at ${viewport.width} x ${viewport.height}`, async () => {
      const { page, problems, leave } = await visit({ viewport });
      await look(page);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= viewport.width, `${wide} pixels wide`);
      assert.deepEqual(problems, []);
      await leave();
    });
  }
}

/**
 * One visitor for all tests of a suite, which leave the page as they found it: a visit costs more than most
 * of what is tried on it.
 * @param {() => Promise<Visitor>} visit
 */
export function oneVisitor(visit) {
  const visitor = /** @type {Visitor} */ ({});
  before(async () => void Object.assign(visitor, await visit()));
  after(async () => {
    await visitor.leave?.();
    assert.deepEqual(visitor.problems, []);
  });
  return visitor;
}

/** A visitor for whom all is ready. */
export async function readyVisitor(/** @type {Promise<Visitor>} */ coming) {
  const visitor = await coming;
  await ready(visitor.page);
  return visitor;
}

/** What a button saves to disk; those of the menu of the page's head are opened first. */
export async function saved(/** @type {Page} */ page, /** @type {string} */ button) {
  if (await page.locator(`#save-menu [data-testid=${button}]`).count())
    await page.getByTestId("save").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  const bytes = await readFile(await download.path());
  return { name: download.suggestedFilename(), text: bytes.toString("utf8"), bytes };
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
  await dataTransfer.dispose();
}

const axe = readFileSync(at("node_modules/axe-core/axe.min.js"), "utf8");

/**
 * What axe-core finds that keeps somebody out, of the colours in the dark too; `rules`: by these rules alone,
 * some of which it does not ask unless told to.
 */
export async function barriers(/** @type {Page} */ page, /** @type {string[]} */ rules = []) {
  await page.evaluate(axe);
  await atRest(page);
  const found = await judged(page, rules);
  if (rules.length > 0) return found;
  const inUse = await page.evaluate(() =>
    matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light",
  );
  await recolour(page, inUse === "dark" ? "light" : "dark");
  found.push(
    ...(await judged(page, ["color-contrast"])).map((barrier) => `in the other colours: ${barrier}`),
  );
  await recolour(page, inUse);
  return found;
}

/** Turns a page that is open dark or light, as its system does. */
export async function recolour(/** @type {Page} */ page, /** @type {"light" | "dark"} */ colorScheme) {
  await page.emulateMedia({ colorScheme });
  await atRest(page);
}

/** Waits until nothing turns from one colour into another any more. */
const atRest = (/** @type {Page} */ page) =>
  page.evaluate(async () => {
    const turning = document.getAnimations().filter((animation) => animation instanceof CSSTransition);
    await Promise.allSettled(turning.map(({ finished }) => finished));
  });

const judged = (/** @type {Page} */ page, /** @type {string[]} */ rules) =>
  page.evaluate(async (rules) => {
    const options = rules.length > 0 ? { runOnly: { type: "rule", values: rules } } : {};
    const { violations } = await /** @type {any} */ (globalThis).axe.run(options);
    return /** @type {import("axe-core").Result[]} */ (violations)
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")}: ${failureSummary}`),
      );
  }, rules);
