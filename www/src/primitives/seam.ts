// How a figure gets from one primitive into another: what would be a jump fades away within a fraction of a second. Geometry only.

/** Frames over which the jump fades. */
export const SEAM_FRAMES = 15;

/** From 1 to 0 with no kink at either end. */
function fade(share: number): number {
  const left = 1 - Math.min(1, Math.max(0, share));
  return left * left * (3 - 2 * left);
}

/** Adds to each frame what is left of the jump. */
export class Seam {
  #jump: Float32Array | null = null;
  #frame = 0;
  /** The last two poses that were handed on. */
  #last: Float32Array | null = null;
  #before: Float32Array | null = null;

  /** The next frame comes from elsewhere. */
  open(): void {
    this.#jump = null;
    this.#opened = true;
  }

  #opened = false;

  /** Takes frames [frames x nodes x 3] on, in place. */
  pass(positions: Float32Array, frames: number): void {
    const width = positions.length / Math.max(1, frames);
    for (let k = 0; k < frames; k++) {
      const pose = positions.subarray(k * width, (k + 1) * width);
      if (this.#opened) this.#measure(pose);
      if (this.#jump) this.#close(pose, this.#jump);
      this.#before = this.#last;
      this.#last = pose.slice();
    }
  }

  /** How far the pose is from where the last two lead. */
  #measure(pose: Float32Array): void {
    this.#opened = false;
    const [last, before] = [this.#last, this.#before];
    if (!last || !before) return;
    this.#jump = pose.map((value, i) => 2 * last[i]! - before[i]! - value);
    this.#frame = 0;
  }

  #close(pose: Float32Array, jump: Float32Array): void {
    const left = fade(this.#frame / SEAM_FRAMES);
    for (let i = 0; i < pose.length; i++) pose[i]! += left * jump[i]!;
    this.#frame += 1;
    if (this.#frame > SEAM_FRAMES) this.#jump = null;
  }
}
