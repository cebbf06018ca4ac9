// The clock of a trial: the cross, then both movements, then nothing. It is asked once for each display frame
// and measures how long each phase took. No rendering.

/** The phase of a trial at a display frame. */
export type Phase = "cross" | "movement" | "over";

/** Measured times of a trial, in milliseconds; null before the movement has begun. */
export interface Shown {
  /** From the first picture of one movement to the first of the other. */
  startedApart: number | null;
  /** From the first picture to the first display frame without one. */
  lasted: number | null;
  /** The length of a display frame, measured during the cross. */
  frame: number | null;
  /** Display frames that the machine was too slow to draw. */
  dropped: number;
}

/** The number of last pictures from which the clock predicts how long the next one takes. */
const RECENT = 5;
/**
 * A machine is busy when a picture takes this many display frames. A busy machine draws no picture that might
 * take this many times the remaining time.
 */
const SLOW = 1.5;

const median = (values: readonly number[]) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? null;

export class PairClock {
  readonly #cross: number;
  readonly #movement: number;
  #crossSince: number | null = null;
  #movesSince: number | null = null;
  #over: number | null = null;
  #before: number | null = null;
  /** The times between display frames during the cross. */
  readonly #intervals: number[] = [];
  #recent: number[] = [];
  #holds = false;
  #dropped = 0;
  readonly #drawnAt = new Map<number, number>();

  /** Seconds of the cross and of the movement. */
  constructor({ crossSeconds, seconds }: { crossSeconds: number; seconds: number }) {
    [this.#cross, this.#movement] = [1000 * crossSeconds, 1000 * seconds];
  }

  /**
   * The phase at a display frame at `now` milliseconds, and the time of the movement in seconds. `hold`: the
   * last picture stays, because a busy machine would finish the next one after the end of the movement.
   */
  at(now: number): { phase: Phase; seconds: number; hold: boolean } {
    const since = this.#before === null ? 0 : now - this.#before;
    this.#before = now;
    if (since > 0 && !this.#holds) this.#recent = [...this.#recent, since].slice(-RECENT);
    this.#crossSince ??= now;
    if (this.#movesSince === null) {
      if (since > 0) this.#intervals.push(since);
      // A phase ends with the display frame that is nearest to its end.
      if (now - this.#crossSince < this.#cross - this.#half())
        return { phase: "cross", seconds: 0, hold: false };
      this.#movesSince = now;
      this.#recent = [];
      return { phase: "movement", seconds: 0, hold: false };
    }
    const frame = this.#frame();
    if (this.#over === null && frame !== null) this.#dropped += Math.max(0, Math.round(since / frame) - 1);
    const moved = now - this.#movesSince;
    const left = this.#movement - moved;
    if (this.#over === null && left > this.#half()) {
      const taken = median(this.#recent) ?? 0;
      this.#holds ||= frame !== null && taken > SLOW * frame && left < SLOW * Math.max(...this.#recent);
      if (this.#holds) this.#dropped += 1;
      return { phase: "movement", seconds: moved / 1000, hold: this.#holds };
    }
    this.#over ??= now;
    return { phase: "over", seconds: this.#movement / 1000, hold: false };
  }

  /** A movement's first picture was drawn at this time. Later calls have no effect. */
  drawn(side: number, time: number): void {
    if (!this.#drawnAt.has(side)) this.#drawnAt.set(side, time);
  }

  /** An answer ended the movement early. */
  stop(now: number): void {
    if (this.#movesSince !== null) this.#over ??= now;
  }

  get shown(): Shown {
    const [left, right] = [this.#drawnAt.get(0), this.#drawnAt.get(1)];
    return {
      startedApart: left === undefined || right === undefined ? null : Math.abs(right - left),
      lasted: this.#movesSince === null || this.#over === null ? null : this.#over - this.#movesSince,
      frame: this.#frame(),
      dropped: this.#dropped,
    };
  }

  #frame(): number | null {
    return median(this.#intervals);
  }

  /** Half a frame of this display. */
  #half(): number {
    return (this.#frame() ?? 0) / 2;
  }
}
