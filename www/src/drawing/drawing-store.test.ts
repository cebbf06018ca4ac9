import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { DrawingStore, type Pad } from "./drawing-store";

let workers: HeldWorkers;
let store: DrawingStore;
beforeEach(() => {
  vi.useFakeTimers();
  workers = new HeldWorkers();
  workers.hold("trainSeries");
  store = new DrawingStore(workers);
});
afterEach(() => {
  vi.useRealTimers();
});

/** Circles on pads within some milliseconds. */
function draw(pads: readonly Pad[], from: number, to: number): void {
  for (let now = from; now <= to; now += 16)
    for (const pad of pads) {
      const turn = (now / 1000) * 2 * Math.PI;
      const [x, y] = [50 + 30 * Math.cos(turn), 66 + 30 * Math.sin(turn)];
      if (now === from) store.begin(pad, x, y, now);
      else store.move(pad, x, y, now);
    }
}
const trainings = () => workers.held("trainSeries");
const parts = () => trainings().map(({ given: [job] }) => job.settings.parts.map(({ name }) => name));

it("waits until both hands have let go", async () => {
  draw([0, 1], 0, 3000);
  store.end(0);
  await vi.advanceTimersByTimeAsync(1000);
  expect(parts()).toEqual([]);
  store.end(1);
  await vi.advanceTimersByTimeAsync(1000);
  expect(parts()).toEqual([["left", "right"]]);
  vi.useRealTimers();
  trainings()[0]?.go();
  await workers.settled();
  // A part of the program arrives while the model learns.
  await vi.waitFor(() => expect(store.drawn?.pads).toEqual([0, 1]));
});

it("forgets a training when the drawing is cleared", async () => {
  draw([0], 0, 3000);
  store.end(0);
  await vi.advanceTimersByTimeAsync(1000);
  store.clear();
  vi.useRealTimers();
  trainings()[0]?.go();
  await workers.settled();
  expect([store.drawn, store.words]).toEqual([null, ""]);
});

it("says that a dot is too little", async () => {
  store.begin(0, 50, 50, 0);
  store.end(0);
  await vi.advanceTimersByTimeAsync(1000);
  expect(parts()).toEqual([]);
  expect(store.words).not.toBe("");
});
