import { describe, expect, it } from "vitest";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import { dividers, moveDivider, weights, weightText } from "./weights";

const precision = (alphas: readonly number[]) => alphas.reduce((sum, alpha) => sum + 1 / alpha, 0);

it("gives weights that sum to 1, the largest to the smallest variance", () => {
  const found = weights([0.1, 0.3, 10]);
  expect(found.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 12);
  expect(found[0]! / found[1]!).toBeCloseTo(3, 12);
  expect(dividers([0.2, 0.5, 0.3])).toEqual([0.2, 0.7]);
});

it("writes a weight without a visible effect as off", () => {
  expect([0, 0.0099, 0.01, 0.5].map(weightText)).toEqual(["≈ 0", "≈ 0", "0.01", "0.50"]);
});

describe("a divider", () => {
  const alphas = [0.1, 0.3, 0.6];

  it("stays where it was moved to, and changes only the weights of its two neighbours", () => {
    const [second, third] = moveDivider(alphas, 1, 0.95);
    const moved = [alphas[0]!, second, third];
    expect(precision(moved)).toBeCloseTo(precision(alphas), 9);
    const [before, after] = [weights(alphas), weights(moved)];
    expect(after[0]).toBeCloseTo(before[0]!, 12);
    expect(dividers(after)[1]).toBeCloseTo(0.95, 12);
  });

  it("changes nothing when it is moved to its own place", () => {
    const place = dividers(weights(alphas))[0]!;
    expect(moveDivider(alphas, 0, place).map((alpha) => alpha.toFixed(9))).toEqual([
      "0.100000000",
      "0.300000000",
    ]);
  });

  it("stops at its neighbours, where one source is off, and keeps to the limits of alpha", () => {
    for (const place of [-1, 0, 1, 2]) {
      const moved = moveDivider(alphas, 0, place);
      expect(moved.every((alpha) => alpha >= ALPHA_MIN * 0.999 && alpha <= ALPHA_MAX * 1.001)).toBe(true);
      const after = weights([...moved, alphas[2]!]);
      expect(weightText(after[place > 0.5 ? 1 : 0]!)).toBe("≈ 0");
    }
  });

  it("does not move where both sources are as weak as possible", () => {
    const weakest = [ALPHA_MAX, ALPHA_MAX];
    expect(moveDivider(weakest, 0, 0.9)).toEqual(weakest);
  });
});
