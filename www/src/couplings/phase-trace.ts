// The phases of all parts over time, with the period and the step that follow from them.
import type { LearnedCycle } from "./learned-cycle";

/** The period is the mean of this many turns: a step with one leg differs from that with the other. */
const TURNS = 2;
/** A part that turns less in the time of a learned turn stands still. */
const STANDING = 0.2;

/** The phases of the last frames of a motion. Adding and reading a frame allocates nothing. */
export class PhaseTrace {
  /** The number of the newest frame; -1 without frames. */
  last = -1;
  #first = 0;
  /** For each part, turns since its first frame, and distances from the cycle; frame t at t % capacity. */
  readonly #turns: readonly Float64Array[];
  readonly #distances: readonly Float64Array[];

  /** Stores the last `capacity` frames. */
  constructor(
    private readonly cycles: readonly LearnedCycle[],
    private readonly capacity: number,
  ) {
    this.#turns = cycles.map(() => new Float64Array(capacity));
    this.#distances = cycles.map(() => new Float64Array(capacity));
  }

  /** Adds a frame. `paths`: the latent path of each part [frames x Q], where the frame is row `row`. */
  add(frame: number, paths: readonly Float64Array[], row: number): void {
    const isNext = frame === this.last + 1 && this.last >= 0;
    for (let part = 0; part < this.cycles.length; part++) {
      const cycle = this.cycles[part]!;
      cycle.place(paths[part]!, row);
      const before = isNext ? this.#turns[part]![this.last % this.capacity]! : 0;
      // The shorter way round from the frame before.
      const step = cycle.phase - before;
      this.#turns[part]![frame % this.capacity] = before + step - (isNext ? Math.round(step) : 0);
      this.#distances[part]![frame % this.capacity] = cycle.distance;
    }
    if (!isNext) this.#first = frame;
    this.#first = Math.max(this.#first, frame - this.capacity + 1);
    this.last = frame;
  }

  /** The turns of a part at a frame, which need not be whole; the fractional part is the phase. */
  turns(part: number, frame: number): number {
    return this.#between(this.#turns[part], frame);
  }

  /** The distance of a part from its cycle at a frame, in radii of the cycle. */
  distance(part: number, frame: number): number {
    return this.#between(this.#distances[part], frame);
  }

  #between(values: Float64Array | undefined, frame: number): number {
    if (!values || this.last < 0) return 0;
    const at = Math.min(Math.max(frame, this.#first), this.last);
    const low = Math.floor(at);
    const a = values[low % this.capacity]!;
    return a + (values[Math.min(low + 1, this.last) % this.capacity]! - a) * (at - low);
  }

  /** Frames of one turn: the mean of the last two; null if two turns are not stored. */
  period(part: number): number | null {
    const values = this.#turns[part];
    if (!values || this.last < 0) return null;
    const goal = values[this.last % this.capacity]! - TURNS;
    for (let frame = this.last - 1; frame >= this.#first; frame--) {
      const before = values[frame % this.capacity]!;
      if (before > goal) continue;
      const after = values[(frame + 1) % this.capacity]!;
      return (this.last - frame - (goal - before) / (after - before)) / TURNS;
    }
    return null;
  }

  /** Whether a part has hardly turned in the time of one learned turn. */
  isStanding(part: number): boolean {
    const values = this.#turns[part];
    const from = this.last - (this.cycles[part]?.frames ?? 0);
    if (!values || from < this.#first) return false;
    return values[this.last % this.capacity]! - values[from % this.capacity]! < STANDING;
  }

  /**
   * The constancy of a part's phase relative to that of the first part over the last `frames`: 1 if both keep
   * step, near 0 if each has its own pace; null before there are as many frames.
   */
  locking(part: number, frames: number): number | null {
    const [first, own] = [this.#turns[0], this.#turns[part]];
    if (!first || !own || this.last - this.#first + 1 < frames) return null;
    let [cosines, sines] = [0, 0];
    for (let frame = this.last - frames + 1; frame <= this.last; frame++) {
      const angle = 2 * Math.PI * (own[frame % this.capacity]! - first[frame % this.capacity]!);
      cosines += Math.cos(angle);
      sines += Math.sin(angle);
    }
    return Math.hypot(cosines, sines) / frames;
  }
}
