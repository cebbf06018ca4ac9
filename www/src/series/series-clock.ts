// The clock of the curves.
import { Clock } from "../stage/clock";

export class SeriesClock extends Clock {
  /** Goes on at the frame now, if there is one. */
  load(frames: number, frameTime: number): void {
    this.player.load(frames, frameTime, frames - 1);
    this.changed();
  }
}
