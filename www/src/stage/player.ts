// The frame now, and how it moves on with time.

export class Player {
  /** The frame now, which need not be whole. */
  frame = 0;
  playing = false;
  speed = 1;
  loops = true;
  #frames = 1;
  #loopEnd = 0;
  #frameTime = 1 / 30;
  /** Whether frames go on arriving. The clock then waits at the last frame. */
  #endless = false;

  /** Plays a motion that loops at frame `loopEnd`, from the frame now if the motion has it. */
  load(frames: number, frameTime: number, loopEnd: number): void {
    this.#frames = frames;
    this.#frameTime = frameTime;
    this.#endless = false;
    this.#loopEnd = Math.min(loopEnd, frames - 1);
    if (this.frame > this.last) this.frame = this.loops ? 0 : this.last;
  }

  /** Plays a live motion whose newest frame is `last`. */
  follow(last: number, frameTime: number): void {
    this.#frames = last + 1;
    this.#frameTime = frameTime;
    this.#endless = true;
  }

  get last(): number {
    return this.#frames - 1;
  }

  /** Moves the clock on by seconds of the visitor's time. Returns the number of laps that ended. */
  advance(seconds: number): number {
    if (!this.playing || this.last < 1) return 0;
    this.frame += (seconds * this.speed) / this.#frameTime;
    if (this.#endless) {
      this.frame = Math.min(this.frame, this.last);
      return 0;
    }
    if (!this.loops) {
      if (this.frame >= this.last) {
        this.frame = this.last;
        this.playing = false;
      }
      return 0;
    }
    // A frame after the end of the loop plays on to the last frame.
    const end =
      this.frame - (seconds * this.speed) / this.#frameTime > this.#loopEnd ? this.last : this.#loopEnd;
    let laps = 0;
    while (this.frame >= end && end > 0) {
      this.frame -= end;
      laps += 1;
    }
    return laps;
  }

  play(): void {
    if (!this.loops && !this.#endless && this.frame >= this.last) this.frame = 0;
    this.playing = true;
  }

  pause(): void {
    this.playing = false;
  }

  /** Stops at the next whole frame in a direction, around the ends. */
  step(direction: 1 | -1): void {
    this.playing = false;
    const next = direction > 0 ? Math.floor(this.frame + 1e-6) + 1 : Math.ceil(this.frame - 1e-6) - 1;
    const beyond = this.#endless ? this.last : 0;
    this.frame = next < 0 ? this.last : next > this.last ? beyond : next;
  }

  scrub(frame: number): void {
    this.frame = Math.min(Math.max(frame, 0), this.last);
  }
}
