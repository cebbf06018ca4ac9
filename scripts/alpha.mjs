// `npm run alpha -- [SITE_FOLDER] [--learned] [--events 200]`: measures the time from a coupling's slider to the new
// motion, in headless Chromium, with experts re-inferred or as learned. For each event it measures three times: in the
// page, from the event to the new positions, and until the page has drawn the figure and all loops anew (the work of
// the graphics card is left out, because most machines without a display have none); in the worker, from the request
// to its answer. Then it measures
// the worker's time for the next frames of a live motion, and the time from a turn of the wheel, and from a move of
// a dragged hand, to the arrival of the first frame that obeys it. The next picture of the display shows this frame.
import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { onPage } from "./chromium.mjs";
import { main } from "./run.mjs";
import { dist } from "./site.mjs";

/** Events before the measurement, while the browser still compiles the program. */
const WARM_UP = 20;
const LIVE_SECONDS = 10;
/** Turns of the wheel, and moves of a hand, each this many milliseconds after the one before. */
const TURNS = 60;
const BETWEEN_TURNS = 100;

/** In a worker: records the times of each request and of its answer. Comlink gives both the same id. */
function recordAnswers() {
  const scope = /** @type {any} */ (globalThis);
  /** @type {Map<string, { asked?: number, answered?: number }>} */
  const records = new Map();
  const record = (/** @type {string} */ id, /** @type {{ asked?: number, answered?: number }} */ when) =>
    records.set(id, { ...records.get(id), ...when });
  // The worker's own listener runs first, so this takes the time of the event and not the present time.
  scope.addEventListener("message", (/** @type {MessageEvent} */ { data, timeStamp }) => {
    if (data?.id) record(data.id, { asked: timeStamp });
  });
  const send = scope.postMessage.bind(scope);
  scope.postMessage = (/** @type {any} */ message, /** @type {any[]} */ ...rest) => {
    send(message, ...rest);
    if (message?.id) record(message.id, { answered: performance.now() });
  };
  scope.forgetAnswers = () => records.clear();
  scope.answerTimes = () =>
    [...records.values()].flatMap(({ asked, answered }) =>
      asked === undefined || answered === undefined ? [] : [answered - asked],
    );
}

/**
 * In the page: moves a slider `events` times, each time after the previous motion has arrived.
 * @param {{ slider: string, events: number }} what
 * @returns {Promise<Record<"motions" | "pictures", number[]>>} milliseconds from each event to its motion, and until all
 * pictures show it
 */
async function slide({ slider, events }) {
  const input = document.querySelector(slider);
  if (!(input instanceof HTMLInputElement)) throw new Error(`the page has no slider ${slider}`);
  const [min, max] = [Number(input.min), Number(input.max)];
  /** The time at which the new positions arrive; the page measures it. */
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
  /** When each canvas was cleared last, to be drawn anew. @type {Map<unknown, number>} */
  const cleared = new Map();
  for (const [context, clear] of /** @type {const} */ ([
    [CanvasRenderingContext2D.prototype, "clearRect"],
    [WebGL2RenderingContext.prototype, "clear"],
  ])) {
    const before = /** @type {any} */ (context)[clear];
    /** @type {any} */ (context)[clear] = function (/** @type {any[]} */ ...words) {
      cleared.set(this.canvas, performance.now());
      return before.apply(this, words);
    };
  }
  const canvases = [...document.querySelectorAll("pg-stage canvas, pg-latent-plot canvas")];
  /** The time at which all pictures have been drawn since. */
  const drawn = async (/** @type {number} */ since) => {
    while (!canvases.every((canvas) => (cleared.get(canvas) ?? 0) >= since))
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    return performance.now();
  };

  /** @type {Record<"motions" | "pictures", number[]>} */
  const times = { motions: [], pictures: [] };
  for (let i = 0; i < events; i++) {
    // Multiples of the golden ratio modulo 1 cover the slider evenly, and successive values differ.
    input.value = String(min + (max - min) * ((i * 0.618) % 1));
    const motion = redrawn();
    const start = performance.now();
    input.dispatchEvent(new Event("input", { bubbles: true }));
    const arrived = /** @type {number} */ (await motion);
    times.motions.push(arrived - start);
    times.pictures.push((await drawn(arrived)) - start);
  }
  return times;
}

/** In the page: the graphics card draws nothing any more. Without one, a picture takes longer than a display frame. */
function leaveOutGraphics() {
  for (const draw of ["drawArrays", "drawArraysInstanced", "drawElements", "drawElementsInstanced"])
    Object.assign(WebGL2RenderingContext.prototype, { [draw]() {} });
}

/** In the page: collects the measures of the wheel and of drags from now on. */
function collectTurns() {
  const scope = /** @type {any} */ (globalThis);
  scope.turns = [];
  new PerformanceObserver((list) =>
    scope.turns.push(...list.getEntriesByName("hand-answer").map(({ duration }) => duration)),
  ).observe({ type: "measure" });
}

/** In the page: moves a dragged node of the figure to and fro. */
function dragNode(/** @type {{ moves: number, between: number }} */ { moves, between }) {
  const scope = /** @type {any} */ (globalThis);
  scope.turns.length = 0;
  const { live } = /** @type {any} */ (document.querySelector("pg-live"));
  const { figure, joints } = live.body;
  const hand = figure.nodes.findIndex((/** @type {any} */ { joint }) =>
    /right.*hand/i.test(joints[joint].name),
  );
  return new Promise((done) => {
    let move = 0;
    const timer = setInterval(() => {
      live.reach(hand, [0.02 * Math.sin(move / 5), 0, 0]);
      if (++move < moves) return;
      clearInterval(timer);
      live.letGo(hand);
      setTimeout(() => done(undefined), between);
    }, between);
  });
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
    options: { learned: { type: "boolean", default: false }, events: { type: "string", default: "200" } },
  });
  const events = Number(values.events);
  const site = resolve(positionals[0] ?? dist);
  await onPage(site, { viewport: { width: 1280, height: 800 } }, async (page, address) => {
    await page.goto(`${address}#view=play`);
    await page.waitForSelector("html[data-engine=ready]");
    // When the sample clips have loaded, the worker is idle.
    await page.getByTestId("train").and(page.locator(":enabled")).waitFor({ state: "attached" });
    // Drawing a walking figure would keep the processor busy.
    await page.getByRole("button", { name: "Pause", exact: true }).click();
    await page.getByTestId("reading").selectOption(values.learned ? "as-learned" : "re-inferred");
    const slider = "[data-testid=coupling-0-1]";
    await page.waitForSelector(slider, { state: "attached" });
    const workers = page.workers();
    for (const worker of workers) await worker.evaluate(recordAnswers);

    await page.evaluate(leaveOutGraphics);
    const times = await page.evaluate(slide, { slider, events: WARM_UP + events });
    print("event to motion", times.motions.slice(WARM_UP));
    print("event to pictures", times.pictures.slice(WARM_UP));
    for (const worker of workers) {
      const times = await worker.evaluate(() => /** @type {any} */ (globalThis).answerTimes());
      if (times.length >= events) print("inside the worker", times.slice(-events));
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
    await page.evaluate(collectTurns);
    await page.getByTestId("wheel").focus();
    for (let turn = 0; turn < TURNS; turn++) {
      await page.keyboard.press("ArrowRight");
      await page.waitForTimeout(BETWEEN_TURNS);
    }
    const turns = () => page.evaluate(() => /** @type {any} */ (globalThis).turns);
    print("wheel to frame", await turns());
    await page.evaluate(dragNode, { moves: TURNS, between: BETWEEN_TURNS });
    print("drag to frame", await turns());
  });
});
