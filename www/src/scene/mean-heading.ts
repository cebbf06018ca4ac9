// The mean heading of a figure, which turns with its walk but does not sway with its steps.
import type { Motion } from "../engine/protocol";
import { placeOnto } from "./motion";

/**
 * Seconds of each of two low-pass filters, one after the other. Together they average over about four
 * seconds: a sway with each step of a walk becomes thirty times smaller.
 */
const SMOOTHING = 1.2;
/** Seconds of a motion whose mean pose and mean heading are those at first. */
const FIRST_SECONDS = 2;

export class MeanHeading {
  /** The pose whose heading is 0; in a mean pose the steps of both sides cancel. */
  #reference: Float32Array = new Float32Array(0);
  #once = 0;
  #twice = 0;

  /** Begins with the mean heading of the first seconds of a motion. */
  start({ positions, frames, nodes, frameTime }: Motion): void {
    const first = Math.max(1, Math.min(frames, Math.round(FIRST_SECONDS / frameTime)));
    this.#reference = new Float32Array(nodes * 3);
    for (let frame = 0; frame < first; frame++) {
      const root = frame * nodes * 3;
      for (let i = 0; i < nodes * 3; i++)
        this.#reference[i]! += (positions[root + i]! - positions[root + (i % 3)]!) / first;
    }
    this.#once = 0;
    this.#twice = 0;
  }

  /** The turn of the mean heading in the `seconds` before this pose, radians about the vertical axis. */
  turn(pose: Float32Array, seconds: number): number {
    if (pose.length !== this.#reference.length) return 0;
    const { yaw } = placeOnto(this.#reference, pose);
    const part = 1 - Math.exp(-seconds / SMOOTHING);
    // The shorter way round.
    const apart = yaw - this.#once;
    this.#once += part * (apart - 2 * Math.PI * Math.round(apart / (2 * Math.PI)));
    const before = this.#twice;
    this.#twice += part * (this.#once - this.#twice);
    return this.#twice - before;
  }
}
