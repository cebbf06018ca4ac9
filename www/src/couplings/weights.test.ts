import { expect, it } from "vitest";
import { weights, weightText } from "./weights";

it("gives weights that sum to 1, the largest to the smallest variance", () => {
  const found = weights([0.1, 0.3, 10]);
  expect(found.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 12);
  expect(found[0]! / found[1]!).toBeCloseTo(3, 12);
});

it("writes a weight without a visible effect as off", () => {
  expect([0, 0.0099, 0.01, 0.5].map(weightText)).toEqual(["≈ 0", "≈ 0", "0.01", "0.50"]);
});
