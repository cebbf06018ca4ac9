// The product of two experts under other couplings, by the formula of the library: experts as learned.
import { weights } from "../../couplings/weights";
import type { PredictionsReport } from "../../engine/protocol";

/** What the experts about a part predict in one frame. */
export interface ExpertsNow {
  /** The mean of each source [Q]. */
  means: Float64Array[];
  /** Variances and covariance of the experts themselves, without alpha: [first, both, second]. */
  own: [first: number, both: number, second: number];
}

export interface Product {
  /** w of each source. */
  weights: number[];
  /** [Q] */
  mean: Float64Array;
  variance: number;
}

/** The two experts about a part in row `row` of a report, under the couplings `alphas` of the report. */
export function expertsOf(
  report: PredictionsReport,
  part: number,
  row: number,
  dimensions: number,
  alphas: readonly number[],
): ExpertsNow {
  const { experts, product } = report.parts[part]!;
  const means = experts.map((expert) => expert.means.slice(row * dimensions, (row + 1) * dimensions));
  const [first, second] = experts.map((expert, source) => expert.variances[row]! - alphas[source]!) as [
    number,
    number,
  ];
  const [w, v] = weights(alphas) as [number, number];
  // The product has the variance alpha^i + w^2 first + 2 w v both + v^2 second, and alpha^i = w alpha.
  const rest = product.variances[row]! - w * alphas[0]! - w * w * first - v * v * second;
  return { means, own: [first, rest / (2 * w * v), second] };
}

/** The product of two experts under the couplings `alphas`. */
export function productOf(
  { means, own: [first, both, second] }: ExpertsNow,
  alphas: readonly number[],
): Product {
  const shares = weights(alphas);
  const [w, v] = shares as [number, number];
  const variance = w * alphas[0]! + Math.max(0, w * w * first + 2 * w * v * both + v * v * second);
  const mean = means[0]!.map((value, a) => w * value + v * means[1]![a]!);
  return { weights: shares, mean, variance };
}
