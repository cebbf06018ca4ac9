import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { modelText } from "../engine/documents.fake";
import { PredictionsStore } from "./predictions-store";

let { workers, model } = new HeldLab();
let predictions: PredictionsStore;
beforeEach(async () => {
  vi.useFakeTimers();
  const lab = new HeldLab();
  ({ workers, model } = lab);
  predictions = new PredictionsStore(lab.store, model);
  await lab.start();
});
afterEach(() => {
  vi.useRealTimers();
});

const held = () => workers.held("predictions");

it("asks for predictions a moment after the rollout", async () => {
  expect(predictions.report).toBeNull();
  await vi.advanceTimersByTimeAsync(100);
  expect(predictions.report?.request).toEqual(model.rollout?.request);
});

it("asks now and then while a coupling moves, and last for the last rollout", async () => {
  await vi.advanceTimersByTimeAsync(100);
  workers.hold("predictions");
  for (let i = 0; i < 40; i++) {
    model.couplings.set(0, 1, 2 + 0.1 * i);
    await vi.advanceTimersByTimeAsync(20);
    // Meanwhile the predictions of the rollout before are shown.
    expect(predictions.report).not.toBeNull();
    held().at(-1)?.go();
  }
  await vi.advanceTimersByTimeAsync(500);
  held().at(-1)!.go();
  await vi.advanceTimersByTimeAsync(0);
  expect(held().length).toBeGreaterThan(1);
  expect(held().length).toBeLessThan(8);
  expect(predictions.report?.request).toEqual(model.rollout?.request);
  expect(model.rollout?.request.alpha?.[0]?.[1]).toBeCloseTo(5.9, 10);
});

it("drops predictions of another model or of other times", async () => {
  await vi.advanceTimersByTimeAsync(100);
  workers.hold("predictions");
  model.setSeconds(4);
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
  await vi.advanceTimersByTimeAsync(100);
  const end = await held()[0]!.late();
  await model.open(modelText(2));
  end();
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
});

it("asks for nothing while predictions are hidden", async () => {
  predictions.show(false);
  model.couplings.set(0, 1, 2);
  await vi.advanceTimersByTimeAsync(500);
  expect([workers.asked("predictions").length, predictions.report]).toEqual([0, null]);
  predictions.show(true);
  await vi.advanceTimersByTimeAsync(500);
  expect(predictions.report?.request.alpha?.[0]?.[1]).toBe(2);
});

it("has no predictions where they cannot be computed", async () => {
  await vi.advanceTimersByTimeAsync(100);
  workers.hold("predictions");
  model.couplings.set(0, 1, 2);
  await vi.advanceTimersByTimeAsync(100);
  held()[0]!.fail(new Error("no covariance"));
  await vi.advanceTimersByTimeAsync(0);
  expect(predictions.report).toBeNull();
});
