// The predictions about a part at a time, which need not be a whole frame.
import type { Predictions, PredictionsReport } from "../engine/protocol";

/** A Gaussian with the same variance in all latent dimensions. */
export interface Gaussian {
  /** [Q] */
  mean: Float64Array;
  variance: number;
}

export interface PartPrediction {
  /** The prediction of each source. */
  experts: Gaussian[];
  product: Gaussian;
}

/** Row `index` of points [n x Q], interpolated between two rows. */
export function interpolate(points: Float64Array, index: number, dimensions: number): Float64Array {
  const rows = points.length / dimensions;
  const low = Math.min(Math.max(Math.floor(index), 0), rows - 1);
  const high = Math.min(low + 1, rows - 1);
  const share = Math.min(Math.max(index - low, 0), 1);
  return Float64Array.from({ length: dimensions }, (_, a) => {
    const [from, to] = [points[low * dimensions + a]!, points[high * dimensions + a]!];
    return from + share * (to - from);
  });
}

/** The predictions about a part at a frame; null in the first frames of a rollout, and after its end. */
export function predictedAt(
  report: PredictionsReport,
  part: number,
  frame: number,
  dimensions: number,
): PartPrediction | null {
  const predictions = report.parts[part];
  const row = frame - report.firstFrame;
  if (!predictions || row < 0 || row > predictions.product.variances.length - 1) return null;
  const at = ({ means, variances }: Predictions): Gaussian => ({
    mean: interpolate(means, row, dimensions),
    variance: interpolate(variances, row, 1)[0]!,
  });
  return { experts: predictions.experts.map(at), product: at(predictions.product) };
}
