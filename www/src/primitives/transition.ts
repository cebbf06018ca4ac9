// How a figure gets from one primitive into another: what would be a jump fades away within a fraction of a
// second. Geometry only.

/** Frames over which the jump fades. */
export const TRANSITION_FRAMES = 15;

/** From 1 to 0 with no kink at either end. */
function fade(share: number): number {
  const left = 1 - Math.min(1, Math.max(0, share));
  return left * left * (3 - 2 * left);
}

/** Where two frames of a figure lead. */
export function onwards(before: Float32Array, last: Float32Array): Float32Array {
  return last.map((value, i) => 2 * value - before[i]!);
}

/** Adds to each frame what is left of the jump. */
export class Transition {
  #jump: Float32Array | null = null;
  /** The frame before the jump. */
  #start = 0;

  /** From this frame on the figure comes from elsewhere: it has this pose, and another one was expected. */
  open(frame: number, pose: Float32Array, expected: Float32Array): void {
    this.#jump = expected.map((value, i) => value - pose[i]!);
    this.#start = frame - 1;
  }

  /** Takes frames [frames x nodes x 3] on, in place; `first` is the number of the first of them. */
  pass(positions: Float32Array, frames: number, first: number): void {
    const jump = this.#jump;
    if (!jump) return;
    for (let k = 0; k < frames; k++) {
      const left = fade((first + k - this.#start) / TRANSITION_FRAMES);
      const pose = positions.subarray(k * jump.length, (k + 1) * jump.length);
      if (left > 0) for (let i = 0; i < pose.length; i++) pose[i]! += left * jump[i]!;
    }
  }
}
