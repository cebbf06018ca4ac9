import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { modelText } from "../engine/engine.fake";
import { PredictionsStore } from "./predictions-store";

let { engine, model } = new FakeLab();
let predictions: PredictionsStore;
beforeEach(async () => {
  vi.useFakeTimers();
  const lab = new FakeLab();
  ({ engine, model } = lab);
  predictions = new PredictionsStore(lab.store, model);
  await lab.start();
});
afterEach(() => {
  vi.useRealTimers();
});

const asked = () => engine.held.filter(({ name }) => name === "predictions").map(({ args }) => args[0]);

it("asks for predictions a moment after the rollout", async () => {
  expect(predictions.report).toBeNull();
  await vi.advanceTimersByTimeAsync(100);
  expect(predictions.report?.request).toEqual(model.rollout?.request);
});

it("asks now and then while a coupling moves, and last for the last rollout", async () => {
  await vi.advanceTimersByTimeAsync(100);
  engine.holding.add("predictions");
  for (let i = 0; i < 40; i++) {
    model.couplings.set(0, 1, 2 + 0.1 * i);
    await vi.advanceTimersByTimeAsync(20);
    // Meanwhile the predictions of the rollout before are shown.
    expect(predictions.report).not.toBeNull();
    engine.held.at(-1)?.end();
  }
  await vi.advanceTimersByTimeAsync(500);
  engine.held.at(-1)?.end();
  await vi.advanceTimersByTimeAsync(0);
  expect(asked().length).toBeGreaterThan(1);
  expect(asked().length).toBeLessThan(8);
  expect(predictions.report?.request).toEqual(model.rollout?.request);
  expect(model.rollout?.request.alpha?.[0]?.[1]).toBeCloseTo(5.9, 10);
});

it("drops predictions of another model or of other times", async () => {
  await vi.advanceTimersByTimeAsync(100);
  engine.holding.add("predictions");
  model.setSeconds(4);
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
  await vi.advanceTimersByTimeAsync(100);
  const late = engine.held.at(-1);
  await model.open(modelText(2));
  late?.end();
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
});

it("asks for nothing while predictions are hidden", async () => {
  predictions.show(false);
  const times = vi.spyOn(engine, "predictions");
  model.couplings.set(0, 1, 2);
  await vi.advanceTimersByTimeAsync(500);
  expect([times.mock.calls.length, predictions.report]).toEqual([0, null]);
  predictions.show(true);
  await vi.advanceTimersByTimeAsync(500);
  expect(predictions.report?.request.alpha?.[0]?.[1]).toBe(2);
});

it("has no predictions where they cannot be computed", async () => {
  await vi.advanceTimersByTimeAsync(100);
  engine.holding.add("predictions");
  model.couplings.set(0, 1, 2);
  await vi.advanceTimersByTimeAsync(100);
  engine.held.at(-1)?.fail(new Error("no covariance"));
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
});
