// The camera's place relative to a figure: as near as the whole motion is visible, and at the same angle to
// the mean heading of the walk.
import { MathUtils, Vector3 } from "three";
import type { Motion } from "../engine/protocol";
import { headingOf, MIDDLE, type View } from "./stance";
import { placeOnto } from "./motion";

/**
 * Seconds of each of two low-pass filters, one after the other. Together they average over about four
 * seconds: a sway with each step of a walk becomes thirty times smaller.
 */
const SMOOTHING = 1.2;
/** Seconds of a motion whose mean pose and mean heading are those at first. */
const FIRST_SECONDS = 2;

class MeanHeading {
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

/** Of a distance to the figure, exp(-CATCH_UP) is left after a second. */
const CATCH_UP = 6;

/** Follows a walk smoothly: an alpha-beta filter, which does not stay behind a constant speed. */
export class Follower {
  /** Metres a second. */
  #x = 0;
  #z = 0;

  /** The way in these seconds towards a figure at this distance. */
  next(dx: number, dz: number, seconds: number): [dx: number, dz: number] {
    const part = 1 - Math.exp(-CATCH_UP * seconds);
    const [x, z] = [this.#x * seconds, this.#z * seconds];
    if (seconds > 0) {
      const gain = part ** 2 / (2 - part) / seconds;
      this.#x += gain * (dx - x);
      this.#z += gain * (dz - z);
    }
    return [x + part * (dx - x), z + part * (dz - z)];
  }

  stop(): void {
    [this.#x, this.#z] = [0, 0];
  }
}

const UP = new Vector3(0, 1, 0);
/** The slope of the first line of sight: the camera is a little above the centre of the picture. */
const SLOPE = 0.1;
/** Of the way to another view, exp(-RATE) is left after a second. */
const RATE = 3;

/**
 * Changes `offset`, the vector from the centre of the picture to the camera. Turns and zooms of the visitor
 * stay, because each change is relative.
 */
export class Framing {
  readonly #mean = new MeanHeading();
  /** The mean heading, radians from the z axis. */
  #heading = 0;
  #now: View = { middle: MIDDLE, distance: 1 };
  /** The view to which the camera moves. */
  wanted: View = this.#now;

  constructor(readonly offset: Vector3) {}

  /** Metres from the ground to the centre of the picture. */
  get middle(): number {
    return this.#now.middle;
  }

  /** Looks from an angle to the mean heading, radians. */
  aim(angle: number): void {
    const from = this.#heading + angle;
    this.offset.set(Math.sin(from), SLOPE, Math.cos(from)).setLength(this.#now.distance);
  }

  /**
   * From where the camera looks: the angle to the mean heading and the angle above the ground in radians, and
   * the distance as a multiple of the present view's.
   */
  get look(): readonly number[] {
    const { x, y, z } = this.offset;
    const turn = Math.atan2(x, z) - this.#heading;
    const distance = this.offset.length();
    return [
      Math.atan2(Math.sin(turn), Math.cos(turn)),
      Math.asin(y / distance),
      distance / this.#now.distance,
    ];
  }

  set look([turn = 0, rise = 0, far = 1]: readonly number[]) {
    const [from, up] = [this.#heading + turn, MathUtils.clamp(rise, 0, 1.4)];
    this.offset
      .set(Math.sin(from) * Math.cos(up), Math.sin(up), Math.cos(from) * Math.cos(up))
      .setLength(MathUtils.clamp(far, 0.3, 3) * this.#now.distance);
  }

  /** Another motion begins, at its own place: the camera keeps its angle to the mean heading. */
  start(motion: Motion): void {
    this.#mean.start(motion);
    this.#turn(headingOf(motion) - this.#heading);
  }

  /** Turns the camera with the mean heading, `seconds` after the last pose. */
  follow(pose: Float32Array, seconds: number): void {
    this.#turn(this.#mean.turn(pose, seconds));
  }

  /** Moves towards the wanted view for `seconds`; without them, to the view at once. */
  approach(seconds = Number.POSITIVE_INFINITY): void {
    const part = 1 - Math.exp(-RATE * seconds);
    const { middle, distance } = this.#now;
    const next = distance + part * (this.wanted.distance - distance);
    this.#now = { middle: middle + part * (this.wanted.middle - middle), distance: next };
    this.offset.multiplyScalar(next / distance);
  }

  #turn(by: number): void {
    this.#heading += by;
    this.offset.applyAxisAngle(UP, by);
  }
}
