// A change that would make the figure jump fades over some frames.
import type { LiveTrack } from "../scene/live-track";

/** Frames in which the jump fades. */
export const TRANSITION_FRAMES = 15;

/** From 1 to 0, smooth at both ends. */
function fade(share: number): number {
  const left = 1 - Math.min(1, Math.max(0, share));
  return left * left * (3 - 2 * left);
}

/** The next pose by linear extrapolation. */
export function extrapolated(before: Float32Array, last: Float32Array): Float32Array {
  return last.map((value, i) => 2 * value - before[i]!);
}

/** Adds the rest of the jump to each frame. */
export class Transition {
  #jump: Float32Array | null = null;
  /** The frame before the jump. */
  #start = 0;

  /** Starts a transition at a frame with this pose, where another pose was expected. */
  start(frame: number, pose: Float32Array, expected: Float32Array): void {
    this.#jump = expected.map((value, i) => value - pose[i]!);
    this.#start = frame - 1;
  }

  /** Changes frames [frames x nodes x 3] in place; `first`: the number of the first frame. */
  apply(positions: Float32Array, frames: number, first: number): void {
    const jump = this.#jump;
    if (!jump) return;
    for (let k = 0; k < frames; k++) {
      const left = fade((first + k - this.#start) / TRANSITION_FRAMES);
      const pose = positions.subarray(k * jump.length, (k + 1) * jump.length);
      if (left > 0) for (let i = 0; i < pose.length; i++) pose[i]! += left * jump[i]!;
    }
  }
}

/** The expected pose after a frame, without changes; null if it is unknown. */
export function expectedAfter(track: LiveTrack, frame: number): Float32Array | null {
  const [before, last, next] = [track.frame(frame - 1), track.frame(frame), track.frame(frame + 1)];
  if (next) return next.slice();
  return before && last && extrapolated(before, last);
}
