// The plane of a plot: the places of points and Gaussians of a latent space, in pixels. For drawing only.
import { project, type Projection, type Turn, turned } from "./projection";

/** The ellipse of one standard deviation of a Gaussian in a plot. */
export interface Ellipse {
  x: number;
  y: number;
  /** Half axes, the longer one first. */
  major: number;
  minor: number;
  /** Direction of the longer axis, radians, clockwise from the right. */
  angle: number;
}

/** The covariance of a Gaussian in the plane: variance to the right, covariance, variance down; pixels². */
export type Spread = [right: number, both: number, down: number];

export interface PlotView {
  width: number;
  height: number;
  projection: Projection;
  turn: Turn;
}

/** The distance from the middle of the cloud to its edge, as a share of the plot. */
const FILLED = 0.41;
/** Pixels from the edge of a plot to the middle of a mark for a point outside. */
const EDGE = 7;

export class Plane {
  readonly #at = new Float64Array(3);
  readonly #scale: number;
  /** Pixels to the right and down for one step in each latent dimension [2 x Q]. */
  readonly #steps: Float64Array;

  constructor(private readonly view: PlotView) {
    const { projection, turn } = view;
    const { axes, dimensions: q } = projection;
    this.#scale = scaleOf(view);
    this.#steps = new Float64Array(2 * q);
    for (let a = 0; a < q; a++) {
      const [right, up] = turned(Float64Array.of(axes[a]!, axes[q + a]!, axes[2 * q + a]!), turn);
      this.#steps[a] = this.#scale * right;
      this.#steps[q + a] = -this.#scale * up;
    }
  }

  /** The plane through the middle of the cloud that the plot shows; null where the plot is turned. */
  get section(): { width: number; height: number; centre: number[]; right: number[]; down: number[] } | null {
    const { width, height, projection, turn } = this.view;
    if (turn.about !== 0 || turn.tilt !== 0 || width < 1 || height < 1) return null;
    return {
      ...{ width: Math.round(width), height: Math.round(height) },
      centre: [...projection.centre],
      ...{ right: this.latentStep(1, 0), down: this.latentStep(0, 1) },
    };
  }

  /** Row `index` of points [n x Q] in pixels from the upper left, and its nearness to the viewer, -1 to 1. */
  place(points: Float64Array, index: number): [number, number, number] {
    const { projection, turn, width, height } = this.view;
    const [right, up, near] = turned(project(projection, points, index, this.#at), turn);
    return [width / 2 + this.#scale * right, height / 2 - this.#scale * up, near / projection.reach];
  }

  /** The nearest place inside the plot, where a mark is visible. */
  inFrame(x: number, y: number, _near = 0): [number, number] {
    const { width, height } = this.view;
    const within = (at: number, size: number) => Math.max(EDGE, Math.min(size - EDGE, at));
    return [within(x, width), within(y, height)];
  }

  /** State `step` of row `index` of histories [n x order*Q]. */
  placeInHistory(
    histories: Float64Array,
    order: number,
    index: number,
    step: number,
  ): [number, number, number] {
    return this.place(histories, index * order + step);
  }

  /** The step in the latent space [Q] that looks like a step of these pixels in the plane. */
  latentStep(right: number, down: number): number[] {
    const q = this.view.projection.dimensions;
    const share = (a: number) => this.#steps[a]! * right + this.#steps[q + a]! * down;
    return Array.from({ length: q }, (_, a) => share(a) / this.#scale ** 2);
  }

  /** The covariance in the plane of a Gaussian with equal variances in the latent space. */
  roundSpread(variance: number): Spread {
    const q = this.view.projection.dimensions;
    const seen: Spread = [0, 0, 0];
    for (let a = 0; a < q; a++) addProduct(seen, this.#steps, q, a, a, variance);
    return seen;
  }

  /** The covariance in the plane of row `index` of covariances [n x Q x Q]. */
  spread(covariances: Float64Array, index: number): Spread {
    const q = this.view.projection.dimensions;
    const seen: Spread = [0, 0, 0];
    for (let a = 0; a < q; a++)
      for (let b = 0; b < q; b++)
        addProduct(seen, this.#steps, q, a, b, covariances[(index * q + a) * q + b]!);
    return seen;
  }
}

/** Pixels for a step of 1, so that the cloud fills the plot; in 3-D from every side. */
function scaleOf({ projection, turn, width, height }: PlotView): number {
  const { reach, flat } = projection;
  if (turn.about !== 0 || turn.tilt !== 0) return (FILLED * Math.min(width, height)) / reach;
  // A cloud that is almost a line is not enlarged without limit.
  const [right, up] = flat.map((half) => Math.max(half, reach / 4)) as [number, number];
  return FILLED * Math.min(width / right, height / up);
}

function addProduct(
  seen: Spread,
  steps: Float64Array,
  q: number,
  a: number,
  b: number,
  covariance: number,
): void {
  seen[0] += covariance * steps[a]! * steps[b]!;
  seen[1] += covariance * steps[a]! * steps[q + b]!;
  seen[2] += covariance * steps[q + a]! * steps[q + b]!;
}

export function ellipseOf([x, y]: readonly number[], [right, both, down]: Spread): Ellipse {
  const middle = (right + down) / 2;
  const apart = Math.hypot((right - down) / 2, both);
  const major = Math.sqrt(Math.max(0, middle + apart));
  const minor = Math.sqrt(Math.max(0, middle - apart));
  return { x: x!, y: y!, major, minor, angle: Math.atan2(2 * both, right - down) / 2 };
}

/** The deviation across a direction of the plane, in pixels. */
export function deviationAcross([right, both, down]: Spread, dx: number, dy: number): number {
  const length = Math.hypot(dx, dy);
  if (length === 0) return 0;
  const [x, y] = [-dy / length, dx / length];
  return Math.sqrt(Math.max(0, right * x * x + 2 * both * x * y + down * y * y));
}
