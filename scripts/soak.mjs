// `npm run soak -- [MINUTES]`: one visitor uses every feature again and again, and each round ends with a
// measurement. After the warm-up, heap, nodes and listeners may grow by a tenth at most, and the pictures a
// second of the figure may fall by a tenth at most.
import { drop, openSite, openPanel, pictures, ready, saved } from "../tests/e2e/site.mjs";
import { bvh } from "../tests/e2e/clips.mjs";
import { Failure, main } from "./run.mjs";

/**
 * After these rounds the page has loaded everything on demand and stores its largest number of comparisons.
 */
const WARM_UP = 12;
/**
 * Without compiled code of the page's scripts, which grows whenever another function becomes frequent.
 */
const NO_CODE = "--js-flags=--no-sparkplug --no-maglev --no-opt";
/**
 * Medians of this many rounds are compared: a single round differs by up to a tenth, depending on what the
 * page draws at that moment.
 */
const ROUNDS = 10;
const MAX_GROWTH = 1.1;
const MIN_PICTURES = 0.9;
const SECONDS = 2;

/** @typedef {{ heap: number, nodes: number, listeners: number, workers: number }} Sizes */

/** The sizes of the page after garbage collection. */
async function sizesOf(
  /** @type {import("playwright-core").CDPSession} */ cdp,
  /** @type {import("playwright-core").Page} */ page,
) {
  for (let k = 0; k < 3; k++) await cdp.send("HeapProfiler.collectGarbage");
  const { metrics } = await cdp.send("Performance.getMetrics");
  const value = (/** @type {string} */ name) =>
    metrics.find((metric) => metric.name === name)?.value ?? Number.NaN;
  return {
    heap: value("JSHeapUsedSize"),
    nodes: value("Nodes"),
    listeners: value("JSEventListeners"),
    workers: page.workers().length,
  };
}

/** Pictures of the figure in a second. */
async function picturesPerSecond(/** @type {import("playwright-core").Page} */ page) {
  const stage = page.getByTestId("stage");
  const [before, start] = [await pictures(stage), performance.now()];
  await page.waitForTimeout(1000 * SECONDS);
  return (1000 * ((await pictures(stage)) - before)) / (performance.now() - start);
}

const median = (/** @type {number[]} */ values) =>
  values.toSorted((a, b) => a - b)[values.length >> 1] ?? Number.NaN;

/** A visitor uses every feature once. */
async function round(
  /** @type {import("playwright-core").Page} */ page,
  /** @type {Record<string, string>} */ clips,
) {
  const trainingIsOver = () => page.getByTestId("train").waitFor({ timeout: 120_000 });
  await drop(page, Object.fromEntries(Object.entries(clips).map(([title, text]) => [`${title}.bvh`, text])));
  for (const title of Object.keys(clips)) await page.getByTestId("own-clips").getByText(title).waitFor();
  await page.getByTestId("train").click();
  await trainingIsOver();
  const { text } = await saved(page, "save-model");
  await openPanel(page, "none");
  const arrow = page.getByTestId("coupling-0-1");
  for (const key of ["ArrowLeft", "ArrowRight", "Home", "End"]) await arrow.press(key);
  for (const tab of /** @type {const} */ (["more", "numbers", "learn"])) await openPanel(page, tab);
  await page.getByTestId("live-on").click();
  await page.getByTestId("live").waitFor();
  await page.waitForTimeout(1000);
  await page.getByTestId("live-on").click();
  await page.getByTestId("view-compare").click();
  await page.getByTestId("compare").and(page.locator(":enabled")).click();
  await page
    .getByTestId("compare-progress")
    .getByText(/trainings? done\.$/)
    .waitFor({ timeout: 120_000 });
  for (const view of ["synthetic", "primitives", "play"]) await page.getByTestId(`view-${view}`).click();
  await drop(page, { "again.model.json": text });
  await page.getByTestId("help").click();
  await page.locator("dialog[open]").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("dialog[open]").waitFor({ state: "detached" });
  await page.locator("pg-training").evaluate((view) => /** @type {any} */ (view).training.clear());
  for (const title of Object.keys(clips)) await page.getByRole("button", { name: `Remove ${title}` }).click();
  await page.getByTestId("own-clips").waitFor({ state: "detached" });
}

await main(async () => {
  const minutes = Number(process.argv[2] ?? "5");
  if (!(minutes > 0)) throw new Failure(`expected minutes above 0, found "${process.argv[2]}"`);
  const site = await openSite({ flags: [NO_CODE] });
  try {
    const settings = "trainings=1&iterations=20&fps=15&dynamics=6&poses=6&models=dmp-rhythmic,dmp-discrete";
    const { page, problems, leave } = await site.visit({ settings, moving: true });
    await ready(page);
    // The page asks about the unsaved results of the previous round.
    await page.addLocatorHandler(page.getByTestId("unsaved"), () =>
      page.getByTestId("unsaved-discard").click(),
    );
    const cdp = await page.context().newCDPSession(page);
    await cdp.send("Performance.enable");
    const clips = { mine: bvh(0), other: bvh(1) };
    /** @type {Sizes[]} */
    const rounds = [];
    const end = Date.now() + 60_000 * minutes;
    /** @type {number[]} */
    const pictures = [];
    console.log("round   heap MB   nodes   listeners   workers   pictures/s");
    for (let k = 1; Date.now() < end || k <= WARM_UP + 2 * ROUNDS; k++) {
      await round(page, clips);
      const now = await sizesOf(cdp, page);
      const { heap, nodes, listeners, workers } = now;
      pictures.push(await picturesPerSecond(page));
      const shown = (pictures.at(-1) ?? 0).toFixed(1).padStart(13);
      const cells = [String(k), (heap / 1e6).toFixed(2), String(nodes), String(listeners), String(workers)];
      console.log(cells.map((cell, i) => cell.padStart([5, 10, 8, 12, 10][i] ?? 0)).join("") + shown);
      if (problems.length > 0) throw new Failure(problems.join("\n"));
      rounds.push(now);
      if (k < WARM_UP + 2 * ROUNDS) continue;
      for (const what of /** @type {const} */ (["heap", "nodes", "listeners", "workers"])) {
        const middle = (/** @type {Sizes[]} */ some) => median(some.map((sizes) => sizes[what]));
        const [warm, last] = [middle(rounds.slice(WARM_UP, WARM_UP + ROUNDS)), middle(rounds.slice(-ROUNDS))];
        if (last > MAX_GROWTH * warm) throw new Failure(`${what}: ${last}, after the warm-up it was ${warm}`);
        if (Date.now() > end) console.log(`${what}, after the warm-up and now: ${warm}, ${last}`);
      }
    }
    const [first, last] = [median(pictures.slice(0, ROUNDS)), median(pictures.slice(-ROUNDS))];
    console.log(`pictures a second, at first and at last: ${first.toFixed(1)}, ${last.toFixed(1)}`);
    if (last < MIN_PICTURES * first)
      throw new Failure(`${last} pictures a second, at first there were ${first}`);
    await leave();
  } finally {
    await site.close();
  }
});
