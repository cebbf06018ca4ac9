// `npm run soak -- [MINUTES]`: one visitor does everything again and again, and what the page holds is
// measured after each round. It must not grow: after the warm-up neither heap nor nodes nor listeners by more
// than a tenth; and the figure walks on with as many pictures a second.
import { drop, openSite, pictures, ready, saved } from "../tests/e2e/site.mjs";
import { bvh } from "../tests/e2e/clips.mjs";
import { Failure, main } from "./run.mjs";

/**
 * Rounds after which all that is loaded on demand is there, and as many comparisons are kept as the page
 * keeps.
 */
const WARM_UP = 12;
/**
 * Machine code of the page's scripts is no part of what the page holds: it grows for as long as another
 * function comes to be used much.
 */
const NO_CODE = "--js-flags=--no-sparkplug --no-maglev --no-opt";
/**
 * The middle of so many rounds is compared: one alone has up to a tenth more or less, by what is being drawn
 * as it is measured.
 */
const SOME = 10;
const MOST = 1.1;
/** Ours: a tenth fewer pictures a second at the end than at the beginning, at most. */
const FEWEST = 0.9;
const SECONDS = 2;

/** @typedef {{ heap: number, nodes: number, listeners: number, workers: number }} Held */

/** What the page holds, once its garbage is gone. */
async function held(
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

/** How many pictures of the figure there are in a second. */
async function picturesPerSecond(/** @type {import("playwright-core").Page} */ page) {
  const stage = page.getByTestId("stage");
  const [before, start] = [await pictures(stage), performance.now()];
  await page.waitForTimeout(1000 * SECONDS);
  return (1000 * ((await pictures(stage)) - before)) / (performance.now() - start);
}

const median = (/** @type {number[]} */ values) =>
  values.toSorted((a, b) => a - b)[values.length >> 1] ?? Number.NaN;

/** Everything that a visitor does. */
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
  const slider = page.getByTestId("coupling-0-1");
  for (const key of ["ArrowLeft", "ArrowRight", "Home", "End"]) await slider.press(key);
  await page.getByTestId("live-on").click();
  await page.getByTestId("live").waitFor();
  await page.waitForTimeout(1000);
  await page.getByRole("button", { name: "clip", exact: true }).click();
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
    // Results of the round before are on no disk.
    await page.addLocatorHandler(page.getByTestId("unsaved"), () =>
      page.getByTestId("unsaved-discard").click(),
    );
    const cdp = await page.context().newCDPSession(page);
    await cdp.send("Performance.enable");
    const clips = { mine: bvh(0), other: bvh(1) };
    /** @type {Held[]} */
    const rounds = [];
    const end = Date.now() + 60_000 * minutes;
    /** @type {number[]} */
    const pictures = [];
    console.log("round   heap MB   nodes   listeners   workers   pictures/s");
    for (let k = 1; Date.now() < end || k <= WARM_UP + 2 * SOME; k++) {
      await round(page, clips);
      const now = await held(cdp, page);
      const { heap, nodes, listeners, workers } = now;
      pictures.push(await picturesPerSecond(page));
      const shown = (pictures.at(-1) ?? 0).toFixed(1).padStart(13);
      console.log(
        `${String(k).padStart(5)}${(heap / 1e6).toFixed(2).padStart(10)}${String(nodes).padStart(8)}${String(listeners).padStart(12)}${String(workers).padStart(10)}${shown}`,
      );
      if (problems.length > 0) throw new Failure(problems.join("\n"));
      rounds.push(now);
      if (k < WARM_UP + 2 * SOME) continue;
      for (const what of /** @type {const} */ (["heap", "nodes", "listeners", "workers"])) {
        const middle = (/** @type {Held[]} */ some) => median(some.map((one) => one[what]));
        const [warm, last] = [middle(rounds.slice(WARM_UP, WARM_UP + SOME)), middle(rounds.slice(-SOME))];
        if (last > MOST * warm) throw new Failure(`${what}: ${last}, after the warm-up it was ${warm}`);
        if (Date.now() > end) console.log(`${what}, after the warm-up and now: ${warm}, ${last}`);
      }
    }
    const [first, last] = [median(pictures.slice(0, SOME)), median(pictures.slice(-SOME))];
    console.log(`pictures a second, at first and at last: ${first.toFixed(1)}, ${last.toFixed(1)}`);
    if (last < FEWEST * first) throw new Failure(`${last} pictures a second, at first there were ${first}`);
    await leave();
  } finally {
    await site.close();
  }
});
