// The kernels of a model, read from its document. No DOM.

/** A Gaussian process: lengthscales are in units of the latent space, one for each input dimension. */
interface Kernel {
  lengthscales: number[];
}

export interface PoseKernel extends Kernel {
  part: string;
  /** sigma^2 */
  variance: number;
  /** beta, the variance of the observation noise. */
  noise: number;
}

export interface ExpertKernel extends Kernel {
  source: number;
  target: number;
  /** alpha, as learned. */
  coupling: number;
}

export interface Kernels {
  /** The number of earlier frames that an expert sees. */
  order: number;
  poses: PoseKernel[];
  /** The experts about the first part come first. Their signal variance is 1. */
  experts: ExpertKernel[];
}

/** The fields of a document; its `lambda` are squared lengthscales. */
interface Document {
  order: number;
  parts: { name: string; lambda: number[]; variance: number; beta: number }[];
  /** By target, then by source. */
  dynamics: { experts: { lambda: number[] }[] }[];
  /** [source][target] */
  alpha: number[][];
}

const lengths = (lambda: readonly number[]) => lambda.map(Math.sqrt);

export function kernelsOf(text: string): Kernels {
  const { order, parts, dynamics, alpha } = JSON.parse(text) as Document;
  return {
    order,
    poses: parts.map(({ name, lambda, variance, beta }) => ({
      part: name,
      variance,
      noise: beta,
      lengthscales: lengths(lambda),
    })),
    experts: dynamics.flatMap(({ experts }, target) =>
      experts.map(({ lambda }, source) => ({
        source,
        target,
        coupling: alpha[source]?.[target] ?? Number.NaN,
        lengthscales: lengths(lambda),
      })),
    ),
  };
}
