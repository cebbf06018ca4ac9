// A clock that visitors play, step and scrub. It notifies its listeners of every frame.
import { Store } from "../ui/store";
import { Player } from "./player";

export class Clock extends Store {
  protected readonly player = new Player();

  /** The frame now, which need not be whole. */
  get frame(): number {
    return this.player.frame;
  }

  get lastFrame(): number {
    return this.player.last;
  }

  get playing(): boolean {
    return this.player.playing;
  }

  /** Seconds of the motion in a second of the visitor's time; 0 while the clock stands. */
  get speed(): number {
    return this.player.playing ? this.player.speed : 0;
  }

  /** Moves the time on by seconds. */
  advance(seconds: number): void {
    if (!this.player.playing) return;
    const laps = this.player.advance(seconds);
    if (laps > 0) this.lapped(laps);
    this.changed();
  }

  play(): void {
    this.player.play();
    this.changed();
  }

  togglePlay(): void {
    if (this.player.playing) this.player.pause();
    else this.player.play();
    this.changed();
  }

  /** Stops at the next whole frame in a direction. */
  step(direction: 1 | -1): void {
    this.player.step(direction);
    this.jumped();
    this.changed();
  }

  /** Stops at a frame. */
  scrub(frame: number): void {
    this.player.pause();
    this.player.scrub(frame);
    this.jumped();
    this.changed();
  }

  /** Goes to a frame, and plays on if the motion plays. */
  seek(frame: number): void {
    this.player.scrub(frame);
    this.jumped();
    this.changed();
  }

  /** Called when laps have ended, before the listeners. */
  protected lapped(_laps: number): void {}

  /** Called when the visitor has chosen another frame, before the listeners. */
  protected jumped(): void {}
}
