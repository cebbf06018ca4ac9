// The one clock of a trial: the cross, then both movements, then nothing. It is asked once a display frame,
// and knows afterwards how long all that took. No rendering.

/** What a trial shows at a display frame. */
export type Phase = "cross" | "movement" | "over";

/** How a movement was shown, in milliseconds; null before it was. */
export interface Shown {
  /** From the first picture of one movement to the first of the other. */
  startedApart: number | null;
  /** From the first picture to the first display frame without one. */
  lasted: number | null;
  /** A frame of this display, as it was while the cross stood. */
  frame: number | null;
  /** Display frames at which the movement should have moved on and did not. */
  dropped: number;
}

/**
 * So many of the last pictures say how long the next will take: a busy machine draws fewer than its display
 * shows.
 */
const RECENT = 5;
/**
 * A machine is busy when a picture takes so many display frames; none is drawn that might take so many times
 * as long as there is time.
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
  /** Between two display frames while the cross stood. */
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
   * What to show at a display frame, `now` milliseconds, and how far the movement is in seconds. `hold`: a
   * busy machine would draw the next picture beyond the end, so that the last one stays, and the end is on
   * time.
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

  /** A movement's first picture was drawn at this time; what comes later does not count. */
  drawn(side: number, time: number): void {
    if (!this.#drawnAt.has(side)) this.#drawnAt.set(side, time);
  }

  /** The movement was ended before its end, by an answer. */
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
