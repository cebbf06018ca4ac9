// The built page in a real browser, served from a sub-folder as on a university's web space.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { buffer } from "node:stream/consumers";
import { after, afterEach, before } from "node:test";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { dist } from "../../scripts/site.mjs";

export { often, seldom } from "../../scripts/node-tests.mjs";

/** @typedef {import("playwright-core").Page} Page */

const DESK = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };

/** Pictures a second of a slow display. */
const PICTURES = 12;

/**
 * Runs in the page: shows few pictures a second, because without a graphics card a walking figure needs more
 * than a core.
 */
function slowDisplay(/** @type {number} */ pictures) {
  const ask = requestAnimationFrame.bind(window);
  /** @type {Map<number, FrameRequestCallback>} */
  let asked = new Map();
  let newest = 0;
  let last = 0;
  const show = (/** @type {number} */ now) => {
    // A few milliseconds early, or one more picture would be left out.
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

/** Runs in the page: the graphics card gets all its data, but draws nothing. */
function noDrawing() {
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
    for (const draw of ["drawArrays", "drawArraysInstanced", "drawElements", "drawElementsInstanced"])
      if (draw in prototype) Object.assign(prototype, { [draw]() {} });
}

/** Runs in the page: counts the clearings of each canvas; three.js clears it once for each picture. */
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
 * @property {string} [settings] as in the page's address; without any the Lab opens
 * @property {boolean} [story] the address has no settings: a first visit opens the story
 * @property {string} [query] the part of the address after "?"
 * @property {number} [cores] the number of cores that the page sees
 * @property {boolean} [moving] the figure walks from the beginning, on a slow display; otherwise the visitor
 * prefers reduced motion
 * @property {number} [pictures] pictures a second of the slow display
 * @property {boolean} [seen] figures are drawn, which takes long without a graphics card; in a small window
 * @property {boolean} [idle] the whole program loads when the page is idle; otherwise when it is needed
 * @property {string} [without] files that fail to load
 */

/**
 * @param {object} [options]
 * @param {string} [options.folder] the built page
 * @param {(path: string) => unknown} [options.before] a file waits for the promise of this function
 * @param {(path: string, bytes: number) => void} [options.onSend] called for each file sent
 */
export async function openSite({ folder = dist, ...options } = {}) {
  // The browser first: a server without one would keep the process of the tests alive.
  const browser = await launchChromium();
  const server = await serve(folder, { prefix: "/some/where/", ...options });
  /** The visitors who stay until the end of their test. @type {Set<Visitor>} */
  const here = new Set();

  /**
   * A new visitor on the page, and the problems during the visit.
   * @param {import("playwright-core").BrowserContextOptions & Visit} [options]
   */
  async function visit({
    settings = "",
    story = false,
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
      // A large picture takes longer to draw.
      viewport: seen ? { width: 900, height: 600 } : DESK,
      reducedMotion: moving ? "no-preference" : "reduce",
      // Only the tests of the service worker use it: it would serve the files.
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
      // Leaving a page aborts its requests.
      if (why !== "net::ERR_ABORTED") problems.push(`failed: ${request.url()} ${why}`);
    });
    context.on("request", (request) => {
      if (/^https?:/.test(request.url()) && !request.url().startsWith(server.address))
        problems.push(`foreign: ${request.url()}`);
    });
    if (without) await page.route(without, (route) => route.abort());
    await page.goto(`${server.address}${query}${story ? "" : `#${settings || "view=play"}`}`);
    const keep = () => void here.delete(visitor);
    const leave = () => {
      keep();
      return context.close();
    };
    const visitor = { page, problems, keep, leave };
    here.add(visitor);
    return visitor;
  }

  return {
    visit,
    here,
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/**
 * The site, opened by the first visit of a test file: of some files no test may run. Visitors leave at the end of
 * their test, without problems.
 */
export function openedSite(/** @type {Parameters<typeof openSite>[0]} */ options = {}) {
  /** @type {ReturnType<typeof openSite> | undefined} */
  let opening;
  const open = () => (opening ??= openSite(options));
  afterEach(async () => {
    for (const { problems, leave } of (await opening)?.here ?? []) {
      await leave();
      assert.deepEqual(problems, []);
    }
  });
  after(async () => (await opening)?.close());
  /** @type {(visitor?: Parameters<Awaited<typeof opening & {}>["visit"]>[0]) => Promise<Visitor>} */
  const visit = async (visitor) => (await open()).visit(visitor);
  return { visit };
}

/** Settings of a training that lasts longer than any test. */
export const LONG = "iterations=5000&dynamics=24&poses=24";

/** Waits until the wasm runs and the sample clips have loaded. */
export async function ready(/** @type {Page} */ page) {
  await page.waitForSelector("html[data-engine=ready], html[data-engine=failed]", { timeout: 30_000 });
  await page
    .getByTestId("train")
    .and(page.locator(":enabled"))
    .waitFor({ state: "attached", timeout: 30_000 });
}

/** Gives an open page another size, and waits until the page is drawn with that size. */
export async function resize(
  /** @type {Page} */ page,
  /** @type {{ width: number, height: number }} */ size,
) {
  await page.setViewportSize(size);
  await drawn(page);
}

/** Waits until the page is drawn as it is now. */
export const drawn = (/** @type {Page} */ page) =>
  page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));

/** Opens a panel of the Lab next to its picture; "none": closes the one that is open. */
export async function openPanel(
  /** @type {Page} */ page,
  /** @type {"none" | "learn" | "more" | "numbers"} */ panel,
) {
  const button = page.locator(panel === "none" ? ".panel-buttons [aria-expanded=true]" : `#open-${panel}`);
  const isDone = panel === "none" ? (await button.count()) === 0 : await isExpanded(button);
  if (!isDone) await button.click();
}

const isExpanded = async (/** @type {import("playwright-core").Locator} */ button) =>
  (await button.getAttribute("aria-expanded")) === "true";

/** Chooses one of the Lab's presets of couplings. */
export const choosePreset = (/** @type {Page} */ page, /** @type {string} */ id) =>
  page.getByTestId("preset").selectOption(id);

/** Waits until the Lab has measured the motion on its stage. */
export const isMeasured = (/** @type {Page} */ page) =>
  page.locator("[data-testid=measured][data-current=yes]").waitFor();

/** Loads the page again as a new visitor of this browser, not as a reload of the tab. */
export async function revisit(/** @type {Page} */ page) {
  await page.evaluate(() => sessionStorage.clear());
  await page.reload();
  await ready(page);
}

/** Whether the picture of an element changes within some milliseconds. */
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
  await soon(async () => assert.ok((await pictures(canvas)) >= end, "the canvas shows three more pictures"));
}

/**
 * Whether the picture of an element stops changing; at first the camera may glide and the picture get finer.
 */
export async function rests(/** @type {import("playwright-core").Locator} */ element) {
  for (let i = 0; i < 10; i++) if (!(await changes(element))) return true;
  return false;
}

/**
 * `keep`: the visitor stays after the test.
 * @typedef {{ page: Page, problems: string[], keep: () => void, leave: () => Promise<void> }} Visitor
 */

/** The name of the test of `keepsNobodyOut`. */
export const ACCESSIBLE = "is accessible and fits the screens of a desk and a phone";

/**
 * A test of a view at the sizes of a desk and of a phone: `look` brings the page into each of its states and calls
 * `fits`, which checks that the page fits the screen and has no barriers.
 * @param {() => Promise<Visitor>} visit
 * @param {(page: Page, fits: (state: string) => Promise<void>) => Promise<void>} look
 */
export const keepsNobodyOut = (visit, look) => async () => {
  const { page } = await visit();
  await look(page, async (state) => {
    for (const size of [PHONE, DESK]) {
      await resize(page, size);
      const where = `${state}, ${size.width} pixels`;
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= size.width, `${where}: ${wide} pixels wide`);
      assert.deepEqual(await (size === DESK ? barriers : barriersNow)(page), [], where);
    }
  });
};

/**
 * One visitor for all tests of a suite, because a visit costs more than most tests. Each test leaves the page
 * as it found it.
 * @param {() => Promise<Visitor>} visit
 */
export function oneVisitor(visit) {
  const visitor = /** @type {Visitor} */ ({});
  before(async () => {
    Object.assign(visitor, await visit());
    visitor.keep();
  });
  after(async () => {
    await visitor.leave?.();
    assert.deepEqual(visitor.problems, []);
  });
  return visitor;
}

/** A visitor whose page is ready. */
export async function readyVisitor(/** @type {Promise<Visitor>} */ coming) {
  const visitor = await coming;
  await ready(visitor.page);
  return visitor;
}

/**
 * Repeats a check until it holds, for 10 seconds unless more are given: a busy machine shows a change late.
 * @template T
 * @param {() => Promise<T>} check
 */
export async function soon(check, seconds = 10) {
  const end = performance.now() + 1000 * seconds;
  for (;;) {
    try {
      return await check();
    } catch (problem) {
      if (performance.now() > end) throw problem;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }
}

/** The bytes of a saved file. */
export const bytesOf = async (/** @type {import("playwright-core").Download} */ download) =>
  buffer(await download.createReadStream());

/** The file that a button saves; opens the menu of the page's head for its buttons. */
export async function saved(/** @type {Page} */ page, /** @type {string} */ button) {
  if (await page.locator(`#save-menu [data-testid=${button}]`).count())
    await page.getByTestId("save").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  const bytes = await bytesOf(download);
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

/** The serious problems that axe-core finds, in light and dark colours. */
export async function barriers(/** @type {Page} */ page) {
  const found = await barriersBy(page, {});
  const inUse = await page.evaluate(() =>
    matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light",
  );
  await recolour(page, inUse === "dark" ? "light" : "dark");
  const others = await barriersBy(page, { runOnly: ["color-contrast"] });
  await recolour(page, inUse);
  return [...found, ...others.map((barrier) => `in the other colours: ${barrier}`)];
}

/** The serious problems but for colours: enough for another language or size. */
export const barriersNow = (/** @type {Page} */ page) =>
  barriersBy(page, { rules: { "color-contrast": { enabled: false } } });

/** The serious problems that axe-core finds with some options. */
export async function barriersBy(
  /** @type {Page} */ page,
  /** @type {import("axe-core").RunOptions} */ options,
) {
  if (!(await page.evaluate(() => "axe" in globalThis))) await page.evaluate(axe);
  await atRest(page);
  return page.evaluate(async (options) => {
    const { violations } = await /** @type {any} */ (globalThis).axe.run(options);
    return /** @type {import("axe-core").Result[]} */ (violations)
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")}: ${failureSummary}`),
      );
  }, options);
}

/** Switches an open page to dark or light colours, as the system does. */
export async function recolour(/** @type {Page} */ page, /** @type {"light" | "dark"} */ colorScheme) {
  await page.emulateMedia({ colorScheme });
  await atRest(page);
}

/** Waits until all changes of colour have ended. */
const atRest = (/** @type {Page} */ page) =>
  page.evaluate(async () => {
    const running = document.getAnimations().filter((animation) => animation instanceof CSSTransition);
    await Promise.allSettled(running.map(({ finished }) => finished));
  });

/** Draws three squares on the pad with the focus, with the arrow keys, whose steps have a time of their own. */
export async function squares(/** @type {Page} */ page) {
  for (let side = 0; side < 12; side++)
    for (let step = 0; step < 4; step++)
      await page.keyboard.press(["ArrowUp", "ArrowRight", "ArrowDown", "ArrowLeft"][side % 4] ?? "");
  await page.keyboard.press("Enter");
}

/** Counts the tones and clicks that the page plays from now on. */
export async function countTones(/** @type {Page} */ page) {
  await page.evaluate(() => {
    Object.assign(window, { tones: 0 });
    window.OscillatorNode = class extends OscillatorNode {
      start() {
        super.start();
        /** @type {any} */ (window).tones++;
      }
    };
  });
  return () => page.evaluate(() => /** @type {any} */ (window).tones);
}
