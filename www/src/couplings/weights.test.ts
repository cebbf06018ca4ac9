import { describe, expect, it } from "vitest";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
<<<<<<< Updated upstream
import { dividersOf, moveDivider, sharesOf, shareWord, weightOf } from "./shares";

const total = (alphas: readonly number[]) => alphas.reduce((sum, alpha) => sum + 1 / alpha, 0);

it("a weight is the share of a source among all that lead to its target", () => {
  const alpha = [
    [1, 4],
    [3, 1],
  ];
  expect(weightOf(alpha, 0, 1)).toBeCloseTo(0.2, 12);
  expect(weightOf(alpha, 1, 0)).toBeCloseTo(0.25, 12);
});

it("the shares sum to 1, and the smaller variance has the larger one", () => {
  const shares = sharesOf([0.1, 0.3, 10]);
  expect(shares.reduce((sum, share) => sum + share)).toBeCloseTo(1, 12);
  expect(shares[0]! / shares[1]!).toBeCloseTo(3, 12);
  expect(dividersOf([0.2, 0.5, 0.3])).toEqual([0.2, 0.7]);
});

it("a share that has no effect is said to be off", () => {
  expect([0, 0.0099, 0.01, 0.5].map(shareWord)).toEqual(["off", "off", "0.01", "0.50"]);
=======
import { dividers, moveDivider, weights, weightText } from "./weights";

const precision = (alphas: readonly number[]) => alphas.reduce((sum, alpha) => sum + 1 / alpha, 0);

it("gives weights that sum to 1, the largest to the smallest variance", () => {
  const found = weights([0.1, 0.3, 10]);
  expect(found.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 12);
  expect(found[0]! / found[1]!).toBeCloseTo(3, 12);
  expect(dividers([0.2, 0.5, 0.3])).toEqual([0.2, 0.7]);
});

it("writes a weight without a visible effect as off", () => {
  expect([0, 0.0099, 0.01, 0.5].map(weightText)).toEqual(["off", "off", "0.01", "0.50"]);
>>>>>>> Stashed changes
});

describe("a divider", () => {
  const alphas = [0.1, 0.3, 0.6];

<<<<<<< Updated upstream
  it("stands where it was moved to, and changes nothing but its two neighbours", () => {
    const [second, third] = moveDivider(alphas, 1, 0.95);
    const moved = [alphas[0]!, second, third];
    expect(total(moved)).toBeCloseTo(total(alphas), 9);
    const [before, after] = [sharesOf(alphas), sharesOf(moved)];
    expect(after[0]).toBeCloseTo(before[0]!, 12);
    expect(dividersOf(after)[1]).toBeCloseTo(0.95, 12);
  });

  it("moved to where it is changes nothing", () => {
    const place = dividersOf(sharesOf(alphas))[0]!;
=======
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
>>>>>>> Stashed changes
    expect(moveDivider(alphas, 0, place).map((alpha) => alpha.toFixed(9))).toEqual([
      "0.100000000",
      "0.300000000",
    ]);
  });

<<<<<<< Updated upstream
  it("stops at its neighbours, where one of the two is off, and keeps to the limits of alpha", () => {
    for (const place of [-1, 0, 1, 2]) {
      const moved = moveDivider(alphas, 0, place);
      expect(moved.every((alpha) => alpha >= ALPHA_MIN * 0.999 && alpha <= ALPHA_MAX * 1.001)).toBe(true);
      const shares = sharesOf([...moved, alphas[2]!]);
      expect(shareWord(shares[place > 0.5 ? 1 : 0]!)).toBe("off");
    }
  });

  it("cannot be moved where both are as weak as can be", () => {
=======
  it("stops at its neighbours, where one source is off, and keeps to the limits of alpha", () => {
    for (const place of [-1, 0, 1, 2]) {
      const moved = moveDivider(alphas, 0, place);
      expect(moved.every((alpha) => alpha >= ALPHA_MIN * 0.999 && alpha <= ALPHA_MAX * 1.001)).toBe(true);
      const after = weights([...moved, alphas[2]!]);
      expect(weightText(after[place > 0.5 ? 1 : 0]!)).toBe("off");
    }
  });

  it("does not move where both sources are as weak as possible", () => {
>>>>>>> Stashed changes
    const weakest = [ALPHA_MAX, ALPHA_MAX];
    expect(moveDivider(weakest, 0, 0.9)).toEqual(weakest);
  });
});
