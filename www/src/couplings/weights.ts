// The weights of the sources of one part, and what moving the divider between two of them means.
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import { weight } from "../ui/format";

/** A source with a smaller weight has no visible effect. */
const OFF = 0.01;

/**
 * The weights w of the sources of one part, from their coupling variances: w^{ji} = alpha^i / alpha^{ji} with
 * alpha^i = 1 / sum_j 1 / alpha^{ji}. The rule is the library's (`coupling_weights`). The page repeats it
 * because a bar follows its slider before the worker answers; `tests/e2e/couplings.test.mjs` compares both.
 */
export function weights(alphas: readonly number[]): number[] {
  const combined = combinedVariance(alphas);
  return alphas.map((alpha) => combined / alpha);
}

/** alpha^i, the variance of the product of all sources. */
function combinedVariance(alphas: readonly number[]): number {
  return 1 / alphas.reduce((sum, alpha) => sum + 1 / alpha, 0);
}

/** The places of the dividers between the sources in a bar, from 0 to 1. */
export function dividers(weights: readonly number[]): number[] {
  let place = 0;
  return weights.slice(0, -1).map((weight) => {
    place += weight;
    return place;
  });
}

/**
 * The variances of the sources `divider` and `divider + 1` when the divider between them moves to `place`, 0
 * to 1. The sum of their weights stays, so that alpha^i and the weights of all other sources stay too: who
 * decides changes, not how exact the prediction has to be.
 */
export function moveDivider(alphas: readonly number[], divider: number, place: number): [number, number] {
  const combined = combinedVariance(alphas);
  const now = weights(alphas);
  const before = now.slice(0, divider).reduce((sum, weight) => sum + weight, 0);
  const both = (now[divider] ?? 0) + (now[divider + 1] ?? 0);
  // Neither variance leaves its limits.
  const [most, least] = [combined / ALPHA_MIN, combined / ALPHA_MAX];
  const left = Math.max(least, both - most, Math.min(both - least, most, place - before));
  return [combined / left, combined / (both - left)];
}

export function isOff(weight: number): boolean {
  return weight < OFF;
}

/** A weight as the table writes it. */
export function weightText(value: number): string {
  return isOff(value) ? "≈ 0" : weight(value);
}
