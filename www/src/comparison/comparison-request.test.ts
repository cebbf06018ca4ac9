import { expect, it } from "vitest";
import { initialSettings } from "../settings/settings";
import { planOf } from "./comparison-request";

it("the plan has the models and values of the settings", () => {
  const plan = planOf({ ...initialSettings(), heldOut: 2, seed: 7, seeds: 2, comparedIterations: 30 });
  expect(plan).toMatchObject({
    heldOut: [2],
    seeds: [7, 8],
    maxIterations: 30,
    primitives: [null],
    trainingTrials: [],
  });
});

it("the plan holds out each trial in turn, or the one that the settings name", () => {
  expect(planOf(initialSettings()).heldOut).toEqual([]);
});
