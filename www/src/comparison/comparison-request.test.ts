import { expect, it } from "vitest";
import { initialSettings } from "../settings/settings";
import { planOf } from "./comparison-request";

it("asks for what the settings say", () => {
  const plan = planOf({ ...initialSettings(), heldOut: 2, seed: 7, seeds: 2, comparedIterations: 30 });
  expect(plan).toMatchObject({
    heldOut: [2],
    seeds: [7, 8],
    maxIterations: 30,
    primitives: [null],
    trainingTrials: [],
  });
});

it("holds out each trial in turn unless one is named", () => {
  expect(planOf(initialSettings()).heldOut).toEqual([]);
});
