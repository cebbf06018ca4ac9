// `npm run alpha -- [SITE_FOLDER] [--learned]`: how long a coupling's slider waits for its motion, in
// headless Chromium; the experts re-inferred, or as learned. Of each event two times are taken: in the page,
// from the event until the new positions are there, and inside the worker, from the message that asks for a
// rollout until the message that answers it. Then the same for a live motion: what the worker takes for the
// next frames (a few at once), while it plays.
import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { launchChromium } from "./chromium.mjs";
import { main } from "./run.mjs";
import { serve } from "./serve.mjs";
import { dist } from "./site.mjs";

const EVENTS = 200;
/** What the compiler of the browser still does to the program is not measured. */
const WARM_UP = 20;
const LIVE_SECONDS = 10;

/** In a worker: notes when each question of the page came and when its answer left. Comlink numbers them. */
function noteAnswers() {
  const scope = /** @type {any} */ (globalThis);
  /** @type {Map<string, { asked?: number, answered?: number }>} */
  const notes = new Map();
  const note = (/** @type {string} */ id, /** @type {{ asked?: number, answered?: number }} */ when) =>
    notes.set(id, { ...notes.get(id), ...when });
  // The worker's own listener is older: its answer may have left when this one is called. Therefore the time
  // of the event.
  scope.addEventListener("message", (/** @type {MessageEvent} */ { data, timeStamp }) => {
    if (data?.id) note(data.id, { asked: timeStamp });
  });
  const send = scope.postMessage.bind(scope);
  scope.postMessage = (/** @type {any} */ message, /** @type {any[]} */ ...rest) => {
    send(message, ...rest);
    if (message?.id) note(message.id, { answered: performance.now() });
  };
  scope.forgetAnswers = () => notes.clear();
  scope.answerTimes = () =>
    [...notes.values()].flatMap(({ asked, answered }) =>
      asked === undefined || answered === undefined ? [] : [answered - asked],
    );
}

/**
 * In the page: moves a slider `events` times, each time after the motion before has come.
 * @param {{ slider: string, events: number }} what
 * @returns {Promise<number[]>} milliseconds from each event to its motion
 */
async function slide({ slider, events }) {
  const input = document.querySelector(slider);
  if (!(input instanceof HTMLInputElement)) throw new Error(`the page has no slider ${slider}`);
  const [min, max] = [Number(input.min), Number(input.max)];
  /** The end of the page's own measure, which it takes when the new positions are there. */
  const redrawn = () =>
    new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error("no motion came within ten seconds")), 10_000);
      const observer = new PerformanceObserver((list) => {
        const [entry] = list.getEntriesByName("coupling-redraw");
        if (!entry) return;
        clearTimeout(late);
        observer.disconnect();
        done(entry.startTime + entry.duration);
      });
      observer.observe({ type: "measure" });
    });
  const drawn = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

  const times = [];
  for (let i = 0; i < events; i++) {
    // Multiples of the golden ratio, without their whole part: spread over the slider, and never one value
    // twice in a row.
    input.value = String(min + (max - min) * ((i * 0.618) % 1));
    const motion = redrawn();
    const start = performance.now();
    input.dispatchEvent(new Event("input", { bubbles: true }));
    times.push((await motion) - start);
    await drawn();
  }
  return times;
}

/** The value below which this share of the values lies. */
const quantile = (/** @type {number[]} */ values, /** @type {number} */ share) =>
  values.toSorted((a, b) => a - b)[Math.ceil(share * values.length) - 1] ?? NaN;

function print(/** @type {string} */ name, /** @type {number[]} */ times) {
  const ms = (/** @type {number} */ share) => `${quantile(times, share).toFixed(2).padStart(7)} ms`;
  console.log(
    `${name.padEnd(20)} 10 % ${ms(0.1)}   median ${ms(0.5)}   95 % ${ms(0.95)}   (${times.length} events)`,
  );
}

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { learned: { type: "boolean", default: false } },
  });
  const { address, close } = await serve(resolve(positionals[0] ?? dist));
  const browser = await launchChromium();
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    await page.goto(address);
    await page.waitForSelector("html[data-engine=ready]");
    // The sample clips are there: the worker has nothing else to do.
    await page.getByTestId("train").and(page.locator(":enabled")).waitFor({ state: "attached" });
    // Where a figure walks, drawing it keeps the processor busy.
    await page.getByRole("button", { name: "Pause", exact: true }).click();
    await page.getByTestId(values.learned ? "reading-learned" : "reading-inferred").click();
    const slider = "[data-testid=coupling-0-1]";
    await page.waitForSelector(slider);
    const workers = page.workers();
    for (const worker of workers) await worker.evaluate(noteAnswers);

    const inPage = await page.evaluate(slide, { slider, events: WARM_UP + EVENTS });
    print("event to motion", inPage.slice(WARM_UP));
    for (const worker of workers) {
      const times = await worker.evaluate(() => /** @type {any} */ (globalThis).answerTimes());
      if (times.length >= EVENTS) print("inside the worker", times.slice(-EVENTS));
    }
    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor();
    for (const worker of workers)
      await worker.evaluate(() => /** @type {any} */ (globalThis).forgetAnswers());
    await page.waitForTimeout(LIVE_SECONDS * 1000);
    for (const worker of workers) {
      const times = await worker.evaluate(() => /** @type {any} */ (globalThis).answerTimes());
      if (times.length > 0) print("live, in the worker", times);
    }
  } finally {
    await browser.close();
    await close();
  }
});
