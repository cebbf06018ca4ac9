// The product of two experts under other couplings, by the formula of the library: experts as learned.
import { weights } from "../../couplings/weights";
import type { PredictionsReport } from "../../engine/protocol";

export interface Product {
  /** w of each source. */
  weights: number[];
  /** [Q] */
  mean: Float64Array;
  /** alpha^i: the variance of the product of two Gaussians with the variances alpha. */
  variance: number;
}

/** The means of the experts about a part in row `row` of a report, one for each source [Q]. */
export function meansOf(
  report: PredictionsReport,
  part: number,
  row: number,
  dimensions: number,
): Float64Array[] {
  const { experts } = report.parts[part]!;
  return experts.map(({ means }) => means.slice(row * dimensions, (row + 1) * dimensions));
}

/** The product of the guesses `means` with the variances `alphas`. */
export function productOf(means: readonly Float64Array[], alphas: readonly number[]): Product {
  const shares = weights(alphas);
  const mean = means[0]!.map((_, a) =>
    means.reduce((sum, guess, source) => sum + shares[source]! * guess[a]!, 0),
  );
  return { weights: shares, mean, variance: shares[0]! * alphas[0]! };
}
