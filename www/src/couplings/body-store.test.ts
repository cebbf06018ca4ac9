import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeLab } from "./lab.fake";
import { modelText } from "../engine/engine.fake";
import { BodyStore } from "./body-store";

let { engine, model } = new FakeLab();
let body: BodyStore;

beforeEach(async () => {
  vi.useFakeTimers();
  const lab = new FakeLab();
  ({ engine, model } = lab);
  body = new BodyStore(lab.store, model);
  await lab.start();
});
afterEach(() => vi.useRealTimers());

const pause = () => vi.advanceTimersByTimeAsync(200);

it("measures 20 seconds, without the first 5, of the motion and of the motion as learned", async () => {
  const asked = vi.spyOn(engine, "bodyReport");
  await pause();
  expect(asked.mock.calls).toEqual([[{ frames: 600, sequence: 0, alpha: null, reading: "as-learned" }, 150]]);
  expect([body.reports?.now, body.isCurrent]).toEqual([body.reports?.learned, true]);
  model.couplings.set(0, 1, 8);
  expect(body.isCurrent).toBe(false);
  await pause();
  expect(body.isCurrent).toBe(true);
  expect(body.reports?.now.request.alpha?.[0]?.[1]).toBe(8);
  // The motion as learned was measured before.
  expect(asked).toHaveBeenCalledTimes(2);
  model.setSeconds(30);
  await pause();
  expect(body.reports?.learned.request.frames).toBe(900);
});

it("waits until the slider rests, and marks the measures of an older motion", async () => {
  await pause();
  const asked = vi.spyOn(engine, "bodyReport");
  for (let i = 1; i <= 10; i++) {
    model.couplings.set(0, 1, 8 + i);
    await vi.advanceTimersByTimeAsync(50);
    expect([asked.mock.calls.length, body.isCurrent]).toEqual([0, false]);
  }
  await pause();
  expect([asked.mock.calls.length, body.isCurrent]).toEqual([1, true]);
});

it("drops the measures of a model that was replaced", async () => {
  engine.holding.add("bodyReport");
  await pause();
  engine.holding.clear();
  await model.open(modelText(2));
  engine.held[0]?.end();
  await vi.advanceTimersByTimeAsync(10);
  expect(body.reports).toBeNull();
  await pause();
  expect(body.reports?.now.revision).toBe(2);
});
