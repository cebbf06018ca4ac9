// What is predicted about a part at a time that need not be a whole frame.
import type { Predictions, PredictionsReport } from "../engine/protocol";

/** A Gaussian with the same variance in all latent dimensions. */
export interface Gaussian {
  /** [Q] */
  mean: Float64Array;
  variance: number;
}

export interface PartPrediction {
  /** What each source says. */
  experts: Gaussian[];
  product: Gaussian;
}

/** Row `index`, which may lie between two rows, of points [n x Q]. */
export function between(points: Float64Array, index: number, dimensions: number): Float64Array {
  const rows = points.length / dimensions;
  const low = Math.min(Math.max(Math.floor(index), 0), rows - 1);
  const high = Math.min(low + 1, rows - 1);
  const share = Math.min(Math.max(index - low, 0), 1);
  return Float64Array.from({ length: dimensions }, (_, a) => {
    const [from, to] = [points[low * dimensions + a]!, points[high * dimensions + a]!];
    return from + share * (to - from);
  });
}

/**
 * What is said about a part at a frame; null where nothing is predicted: in the frames that a rollout begins
 * with, and behind its end.
 */
export function predictedAt(
  report: PredictionsReport,
  part: number,
  frame: number,
  dimensions: number,
): PartPrediction | null {
  const said = report.parts[part];
  const row = frame - report.firstFrame;
  if (!said || row < 0 || row > said.product.variances.length - 1) return null;
  const at = ({ means, variances }: Predictions): Gaussian => ({
    mean: between(means, row, dimensions),
    variance: between(variances, row, 1)[0]!,
  });
  return { experts: said.experts.map(at), product: at(said.product) };
}
