// `npm run soak -- [MINUTES]`: one visitor does everything again and again, and what the page holds is measured after each round. It must not
// grow: after the warm-up neither heap nor nodes nor listeners by more than a tenth.
import { drop, openSite, ready, saved } from "../tests/e2e/site.mjs";
import { bvh } from "../tests/e2e/clips.mjs";
import { Failure, main } from "./run.mjs";

/** Rounds after which all that is loaded on demand is there. */
const WARM_UP = 3;
const MOST = 1.1;

/** @typedef {{ heap: number, nodes: number, listeners: number, workers: number }} Held */

/** What the page holds, once its garbage is gone. */
async function held(
  /** @type {import("playwright-core").CDPSession} */ cdp,
  /** @type {import("playwright-core").Page} */ page,
) {
  for (let k = 0; k < 3; k++) await cdp.send("HeapProfiler.collectGarbage");
  const { metrics } = await cdp.send("Performance.getMetrics");
  const value = (/** @type {string} */ name) => metrics.find((metric) => metric.name === name)?.value ?? Number.NaN;
  return {
    heap: value("JSHeapUsedSize"),
    nodes: value("Nodes"),
    listeners: value("JSEventListeners"),
    workers: page.workers().length,
  };
}

/** Everything that a visitor does. */
async function round(/** @type {import("playwright-core").Page} */ page, /** @type {string} */ clip) {
  const trainingIsOver = () => page.getByTestId("train").waitFor({ timeout: 120_000 });
  await drop(page, { "mine.bvh": clip });
  await page.getByTestId("own-clips").getByText("mine").waitFor();
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
  await page.getByRole("button", { name: "Remove mine" }).click();
  await page.getByTestId("own-clips").waitFor({ state: "detached" });
}

await main(async () => {
  const minutes = Number(process.argv[2] ?? "5");
  if (!(minutes > 0)) throw new Failure(`expected minutes above 0, found "${process.argv[2]}"`);
  const site = await openSite();
  try {
    const settings = "trainings=1&iterations=20&fps=15&dynamics=6&poses=6&models=dmp-rhythmic,dmp-discrete";
    const { page, problems, leave } = await site.visit({ settings, moving: true });
    await ready(page);
    // Results of the round before are on no disk.
    await page.addLocatorHandler(page.getByTestId("unsaved"), () => page.getByTestId("unsaved-discard").click());
    const cdp = await page.context().newCDPSession(page);
    await cdp.send("Performance.enable");
    const clip = bvh();
    /** @type {Held | null} */
    let warm = null;
    const end = Date.now() + 60_000 * minutes;
    console.log("round   heap MB   nodes   listeners   workers");
    for (let k = 1; Date.now() < end || k <= WARM_UP + 1; k++) {
      await round(page, clip);
      const now = await held(cdp, page);
      const { heap, nodes, listeners, workers } = now;
      console.log(
        `${String(k).padStart(5)}${(heap / 1e6).toFixed(2).padStart(10)}${String(nodes).padStart(8)}${String(listeners).padStart(12)}${String(workers).padStart(10)}`,
      );
      if (problems.length > 0) throw new Failure(problems.join("\n"));
      if (k === WARM_UP) warm = now;
      if (!warm) continue;
      for (const what of /** @type {const} */ (["heap", "nodes", "listeners", "workers"]))
        if (now[what] > MOST * warm[what])
          throw new Failure(`${what}: ${now[what]}, after the warm-up it was ${warm[what]}`);
    }
    await leave();
  } finally {
    await site.close();
  }
});
