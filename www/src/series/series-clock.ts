// The clock of the curves.
import { Clock } from "../stage/clock";

export class SeriesClock extends Clock {
  /** Stays at the current frame if the new rollout has this frame. */
  load(frames: number, frameTime: number): void {
    this.player.load(frames, frameTime, frames - 1);
    this.changed();
  }
}
