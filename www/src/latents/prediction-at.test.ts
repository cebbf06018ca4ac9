import { describe, expect, it } from "vitest";
import type { PredictionsReport, RolloutRequest } from "../engine/protocol";
import { sameTimes } from "../couplings/weights";
import { interpolate, predictedAt } from "./prediction-at";

const request: RolloutRequest = { frames: 5, sequence: 0, alpha: null, reading: "as-learned" };
const predictions = (offset: number) => ({
  means: Float64Array.of(0, 10, 1, 20, 4, 30).map((x) => x + offset),
  variances: Float64Array.of(1, 3, 5).map((x) => x + offset),
});
const report: PredictionsReport = {
  revision: 1,
  request,
  firstFrame: 2,
  parts: [{ experts: [predictions(0), predictions(100)], product: predictions(200) }],
};

describe("a prediction", () => {
  it("is the row of its frame, and interpolated between two frames", () => {
    const at = predictedAt(report, 0, 3, 2);
    expect([...(at?.experts[0]?.mean ?? [])]).toEqual([1, 20]);
    expect(at?.experts[1]?.variance).toBe(103);
    const later = predictedAt(report, 0, 3.5, 2);
    expect([...(later?.product.mean ?? [])]).toEqual([202.5, 225]);
    expect(later?.product.variance).toBe(204);
  });

  it("is missing in the first frames, after the end and for an unknown part", () => {
    expect(predictedAt(report, 0, 1.9, 2)).toBeNull();
    expect(predictedAt(report, 0, 2, 2)).not.toBeNull();
    expect(predictedAt(report, 0, 4, 2)).not.toBeNull();
    expect(predictedAt(report, 0, 4.1, 2)).toBeNull();
    expect(predictedAt(report, 1, 3, 2)).toBeNull();
  });
});

it("repeats the ends of a path beyond them", () => {
  const path = Float64Array.of(0, 1, 2, 3);
  expect([...interpolate(path, -1, 2)]).toEqual([0, 1]);
  expect([...interpolate(path, 7, 2)]).toEqual([2, 3]);
  expect([...interpolate(path, 0.25, 2)]).toEqual([0.5, 1.5]);
});

it("compares the times of two rollouts", () => {
  expect(sameTimes(request, { ...request, alpha: [[1]] })).toBe(true);
  expect(sameTimes(request, { ...request, frames: 6 })).toBe(false);
  expect(sameTimes(request, { ...request, sequence: 1 })).toBe(false);
  expect(sameTimes(request, { ...request, frame: 1 })).toBe(false);
});
