// The phase of a part: the nearest point on one period of the motion as learned.

/** A wave of this many frames is too short to have a phase. */
const FEWEST_FRAMES = 6;

/**
 * One period of a part's learned latent path. Its state at a frame is the history from which the model
 * predicts: the latents of the last `order` frames. The nearest state stays unique where the loop crosses
 * itself, and a part that slows down or swings less keeps its phase.
 */
export class LearnedCycle {
  /** The place of the state last passed to `place`, in turns, 0 to 1. */
  phase = 0;
  /** The distance of this state from the cycle, in radii of the cycle. */
  distance = 0;
  readonly #path: Float64Array;
  readonly #dimensions: number;
  readonly #order: number;
  readonly #first: number;
  readonly #radius: number;

  /** The last `frames` frames of a path [frames x dimensions]. */
  private constructor(
    path: Float64Array,
    dimensions: number,
    order: number,
    readonly frames: number,
  ) {
    this.#path = path;
    this.#dimensions = dimensions;
    this.#order = order;
    this.#first = path.length / dimensions - frames;
    this.#radius = this.#rootMeanSquare();
  }

  /** The cycle of a path with this period in frames; null for a path that is too short or does not move. */
  static from(path: Float64Array, dimensions: number, order: number, period: number): LearnedCycle | null {
    const frames = Math.round(period);
    if (frames < FEWEST_FRAMES || path.length / dimensions < frames + order - 1) return null;
    const cycle = new LearnedCycle(path, dimensions, order, frames);
    return cycle.#radius > 1e-3 ? cycle : null;
  }

  /** Finds the phase and the distance of a frame of a path. The first frames count as their first state. */
  place(path: Float64Array, frame: number): void {
    const start = Math.max(0, frame - this.#order + 1) * this.#dimensions;
    let nearest = 0;
    let least = Number.POSITIVE_INFINITY;
    for (let k = 0; k < this.frames; k++) {
      const squared = this.#squared(k, path, start);
      if (squared >= least) continue;
      nearest = k;
      least = squared;
    }
    // The minimum of the parabola through the nearest state and its neighbours.
    const before = this.#squared((nearest + this.frames - 1) % this.frames, path, start);
    const after = this.#squared((nearest + 1) % this.frames, path, start);
    const bend = before - 2 * least + after;
    const shift = bend > 0 ? Math.min(0.5, Math.max(-0.5, (0.5 * (before - after)) / bend)) : 0;
    this.phase = ((((nearest + shift) / this.frames) % 1) + 1) % 1;
    this.distance = Math.sqrt(Math.max(0, least - 0.25 * (before - after) * shift)) / this.#radius;
  }

  /** The squared distance of the cycle's state `k` from the state that begins at `start`. */
  #squared(k: number, path: Float64Array, start: number): number {
    const own = (this.#first + k - this.#order + 1) * this.#dimensions;
    let sum = 0;
    for (let i = 0; i < this.#order * this.#dimensions; i++) {
      const difference = this.#path[own + i]! - path[start + i]!;
      sum += difference * difference;
    }
    return sum;
  }

  /** The root mean square distance of the states from their mean. */
  #rootMeanSquare(): number {
    const width = this.#order * this.#dimensions;
    const start = (this.#first - this.#order + 1) * this.#dimensions;
    let sum = 0;
    for (let i = 0; i < width; i++) {
      let mean = 0;
      for (let k = 0; k < this.frames; k++)
        mean += this.#path[start + k * this.#dimensions + i]! / this.frames;
      for (let k = 0; k < this.frames; k++)
        sum += (this.#path[start + k * this.#dimensions + i]! - mean) ** 2 / this.frames;
    }
    return Math.sqrt(sum);
  }
}
