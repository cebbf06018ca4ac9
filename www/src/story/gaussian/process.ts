// A Gaussian process of one input with inducing points, in the form of the library: K, A = K + Psi2 / n, b.
// With an inducing point at each data point it is the exact process.

/** A data point. */
export type Point = readonly [x: number, y: number];

export interface Prediction {
  mean: number;
  variance: number;
}

export interface KernelOfOne {
  /** Squared lengthscale. */
  lambda: number;
  /** Signal variance. */
  variance: number;
}

const JITTER = 1e-8;

export const kernel = ({ lambda, variance }: KernelOfOne, a: number, b: number): number =>
  variance * Math.exp((-0.5 * (a - b) ** 2) / lambda);

type Matrix = number[][];

/** The lower factor of a positive definite matrix. */
function cholesky(matrix: Matrix): Matrix {
  const lower: Matrix = matrix.map((row) => row.map(() => 0));
  for (let i = 0; i < matrix.length; i++)
    for (let j = 0; j <= i; j++) {
      let sum = matrix[i]![j]!;
      for (let k = 0; k < j; k++) sum -= lower[i]![k]! * lower[j]![k]!;
      lower[i]![j] = i === j ? Math.sqrt(Math.max(sum, 1e-300)) : sum / lower[j]![j]!;
    }
  return lower;
}

function solve(lower: Matrix, right: readonly number[]): number[] {
  const x = [...right];
  for (let i = 0; i < x.length; i++) {
    for (let k = 0; k < i; k++) x[i]! -= lower[i]![k]! * x[k]!;
    x[i]! /= lower[i]![i]!;
  }
  for (let i = x.length - 1; i >= 0; i--) {
    for (let k = i + 1; k < x.length; k++) x[i]! -= lower[k]![i]! * x[k]!;
    x[i]! /= lower[i]![i]!;
  }
  return x;
}

const inverse = (matrix: Matrix): Matrix => {
  const lower = cholesky(matrix);
  return matrix.map((_, i) =>
    solve(
      lower,
      matrix.map((_, j) => (i === j ? 1 : 0)),
    ),
  );
};

export class Process {
  readonly #kernel: KernelOfOne;
  /** K^-1 E[u] = A^-1 b / n. */
  readonly #coefficients: number[];
  /** K^-1 - A^-1. */
  readonly #certainty: Matrix;

  /** `noise`: the variance of the noise of the data. */
  constructor(
    data: readonly Point[],
    private readonly inducing: readonly number[],
    of: KernelOfOne,
    noise: number,
  ) {
    this.#kernel = of;
    const k = inducing.map((a, i) =>
      inducing.map((b, j) => kernel(of, a, b) + (i === j ? JITTER * of.variance : 0)),
    );
    const rows = data.map(([x]) => inducing.map((a) => kernel(of, x, a)));
    const a = k.map((row, i) =>
      row.map((value, j) => value + rows.reduce((sum, at) => sum + at[i]! * at[j]!, 0) / noise),
    );
    const b = inducing.map((_, i) => data.reduce((sum, [, y], t) => sum + rows[t]![i]! * y, 0) / noise);
    this.#coefficients = solve(cholesky(a), b);
    const [prior, posterior] = [inverse(k), inverse(a)];
    this.#certainty = prior.map((row, i) => row.map((value, j) => value - posterior[i]![j]!));
  }

  /** The function at an input that is Gaussian with this mean and variance, by the psi statistics. */
  at(x: number, inputVariance = 0): Prediction {
    const { lambda, variance } = this.#kernel;
    const z = this.inducing;
    const wide = lambda + inputVariance;
    const psi1 = z.map((a) => variance * Math.sqrt(lambda / wide) * Math.exp((-0.5 * (x - a) ** 2) / wide));
    const wider = lambda + 2 * inputVariance;
    const psi2 = (a: number, b: number) =>
      variance ** 2 *
      Math.sqrt(lambda / wider) *
      Math.exp(-((a - b) ** 2) / (4 * lambda) - (x - (a + b) / 2) ** 2 / wider);
    const mean = psi1.reduce((sum, value, i) => sum + value * this.#coefficients[i]!, 0);
    let rest = variance - mean * mean;
    z.forEach((a, i) =>
      z.forEach((b, j) => {
        const share = this.#coefficients[i]! * this.#coefficients[j]! - this.#certainty[i]![j]!;
        rest += psi2(a, b) * share;
      }),
    );
    return { mean, variance: Math.max(0, rest) };
  }
}
