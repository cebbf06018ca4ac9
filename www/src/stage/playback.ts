// The clock of the stage: the motion that plays, the frame now, and the place of the figure.
import type { Motion } from "../engine/protocol";
import type { LiveTrack } from "../scene/live-track";
import { Walk } from "../scene/motion";
import type { SettingsStore } from "../settings/settings-store";
import { Clock } from "./clock";

export class Playback extends Clock {
  #walk: Walk | null = null;
  /** The live motion in front of the walk. */
  #live: LiveTrack | null = null;
  /** Loops that have ended. */
  laps = 0;

  /** The settings give speed and loop. Without them, the motion repeats at its own speed. */
  constructor(settings?: SettingsStore) {
    super();
    if (!settings) return;
    const follow = () => {
      this.player.speed = settings.values.speed;
      this.player.loops = settings.values.loop;
    };
    follow();
    settings.on(follow);
  }

  /** The figure's nodes now [nodes x 3]; null before the first motion. */
  get pose(): Float32Array | null {
    return (this.#live ?? this.#walk)?.at(this.player.frame) ?? null;
  }

  /** A displacement on the stage in the axes of the motion before its placement. */
  turnedBack(by: readonly [number, number, number]): [number, number, number] {
    return (this.#live ?? this.#walk)?.turnedBack(by) ?? [0, 0, 0];
  }

  /** Seconds of the motion now. */
  get seconds(): number {
    return this.frame * (this.#walk?.motion.frameTime ?? 0);
  }

  /** Goes to a time of the motion, in seconds. */
  seekSeconds(seconds: number): void {
    if (this.#walk) this.seek(seconds / this.#walk.motion.frameTime);
  }

  /**
   * Plays a motion. `whole`: a lap has all frames, however different the ends are. `goesOn`: a motion of the
   * same figure continues at the same place and time.
   */
  load(motion: Motion, { whole, goesOn }: { whole: boolean; goesOn: boolean }): void {
    const before = goesOn && this.#walk?.motion.nodes === motion.nodes ? (this.pose?.slice() ?? null) : null;
    if (!before || this.#live) this.player.frame = 0;
    this.#live = null;
    this.#walk = new Walk(motion, whole);
    this.player.load(motion.frames, motion.frameTime, this.#walk.loop.end);
    if (before) this.#walk.alignWith(this.player.frame, before);
    this.changed();
  }

  /** Plays a live motion from the place of the figure. Called again when frames have arrived. */
  follow(track: LiveTrack): void {
    if (this.#live !== track) {
      const before = this.pose?.slice();
      if (before) track.alignWith(before);
      this.player.frame = track.first;
    }
    this.#live = track;
    this.player.follow(track.last, track.motion.frameTime);
    this.changed();
  }

  protected override lapped(laps: number): void {
    for (let lap = 0; lap < laps; lap++) this.#walk?.lap();
    this.laps += laps;
  }

  protected override jumped(): void {
    this.#walk?.resetPlacement();
  }
}
