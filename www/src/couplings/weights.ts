// The weights of the sources of one part.
import { weight } from "../ui/format";
import type { RolloutRequest } from "../engine/protocol";

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

export function isOff(weight: number): boolean {
  return weight < OFF;
}

/** A weight as the table writes it. */
export function weightText(value: number): string {
  return isOff(value) ? "≈ 0" : weight(value);
}

/** Whether two rollouts have the same start and the same length. */
export function sameTimes(a: RolloutRequest, b: RolloutRequest): boolean {
  const times = ({ frames, sequence, frame, start }: RolloutRequest) =>
    JSON.stringify([frames, sequence, frame, start]);
  return times(a) === times(b);
}
