// Reading a motion between its frames, placing it on the ground, and finding where it can loop. Geometry
// only.
import type { Motion } from "../engine/protocol";

/** A turn about the vertical axis followed by a shift on the ground. */
export interface Placement {
  yaw: number;
  x: number;
  z: number;
}

export const HERE: Placement = { yaw: 0, x: 0, z: 0 };

/** The pose at a frame that need not be whole [nodes x 3], placed on the ground. */
export function poseAt(motion: Motion, frame: number, placement: Placement, out: Float32Array): Float32Array {
  const { positions, frames, nodes } = motion;
  const at = Math.min(Math.max(frame, 0), frames - 1);
  const low = Math.floor(at);
  const part = at - low;
  const a = low * nodes * 3;
  const b = Math.min(low + 1, frames - 1) * nodes * 3;
  const c = Math.cos(placement.yaw);
  const s = Math.sin(placement.yaw);
  for (let i = 0; i < nodes * 3; i += 3) {
    const x = mix(positions[a + i]!, positions[b + i]!, part);
    const z = mix(positions[a + i + 2]!, positions[b + i + 2]!, part);
    out[i] = c * x + s * z + placement.x;
    out[i + 1] = mix(positions[a + i + 1]!, positions[b + i + 1]!, part);
    out[i + 2] = c * z - s * x + placement.z;
  }
  return out;
}

function mix(a: number, b: number, part: number): number {
  return a + (b - a) * part;
}

/** out = (1 - part) out + part other. */
export function blendInto(out: Float32Array, other: Float32Array, part: number): void {
  for (let i = 0; i < out.length; i++) out[i] = mix(out[i]!, other[i]!, part);
}

/**
 * The placement that lays `pose` onto `target` as well as a turn and a shift can, with the roots (node 0) in
 * one place.
 */
export function placeOnto(pose: Float32Array, target: Float32Array): Placement {
  let dot = 0;
  let cross = 0;
  for (let i = 3; i < pose.length; i += 3) {
    const x = pose[i]! - pose[0]!;
    const z = pose[i + 2]! - pose[2]!;
    const tx = target[i]! - target[0]!;
    const tz = target[i + 2]! - target[2]!;
    dot += x * tx + z * tz;
    cross += z * tx - x * tz;
  }
  const yaw = dot === 0 && cross === 0 ? 0 : Math.atan2(cross, dot);
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  return {
    yaw,
    x: target[0]! - (c * pose[0]! + s * pose[2]!),
    z: target[2]! - (c * pose[2]! - s * pose[0]!),
  };
}

/**
 * How far the nodes of a motion are from those of another one, on average over the nodes, the roots laid in
 * one place and facing one way [frames]; metres.
 */
export function distances(motion: Motion, from: Motion): Float64Array {
  const frames = Math.min(motion.frames, from.frames);
  const pose = new Float32Array(motion.nodes * 3);
  const other = pose.slice();
  return Float64Array.from({ length: frames }, (_, frame) => {
    poseAt(motion, frame, HERE, pose);
    poseAt(from, frame, HERE, other);
    poseAt(from, frame, placeOnto(other, pose), other);
    let sum = 0;
    for (let i = 0; i < pose.length; i += 3)
      sum += Math.hypot(pose[i]! - other[i]!, pose[i + 1]! - other[i + 1]!, pose[i + 2]! - other[i + 2]!);
    return sum / motion.nodes;
  });
}

/** First `first`, then `then`. */
export function chain(first: Placement, then: Placement): Placement {
  const c = Math.cos(then.yaw);
  const s = Math.sin(then.yaw);
  return {
    yaw: first.yaw + then.yaw,
    x: c * first.x + s * first.z + then.x,
    z: c * first.z - s * first.x + then.z,
  };
}

function distance(a: Float32Array, b: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i]! - b[i]!) ** 2;
  return sum;
}

export interface Loop {
  /** The frame at which the motion goes on as if at frame 0. */
  end: number;
  /** Lays frame 0 onto frame `end`. */
  placement: Placement;
}

/** Frames over which one lap fades into the next. */
export const FADE = 6;

/** From the last frame back to the first. */
function wholeLoop(motion: Motion): Loop {
  const pose = (frame: number) => poseAt(motion, frame, HERE, new Float32Array(motion.nodes * 3));
  const last = motion.frames - 1;
  return { end: last, placement: last > 0 ? placeOnto(pose(0), pose(last)) : HERE };
}

/**
 * Where to loop: of the frames of the last two seconds, the one most like frame 0 that also moves on as frame
 * 0 does.
 */
export function findLoop(motion: Motion): Loop {
  const width = motion.nodes * 3;
  const pose = (frame: number) => poseAt(motion, frame, HERE, new Float32Array(width));
  const last = motion.frames - 1;
  if (last < 2 * FADE) return wholeLoop(motion);
  const start = pose(0);
  const next = pose(3);
  const from = Math.max(Math.floor(last / 2), last - FADE - Math.round(2 / motion.frameTime));
  let best: Loop & { cost: number } = { end: last, placement: HERE, cost: Infinity };
  for (let end = from; end <= last - FADE; end++) {
    const placement = placeOnto(start, pose(end));
    const cost =
      distance(poseAt(motion, 0, placement, start.slice()), pose(end)) +
      distance(poseAt(motion, 3, placement, next), pose(end + 3));
    if (cost < best.cost) best = { end, placement, cost };
  }
  return best;
}

/**
 * Plays a motion lap after lap, without a jump where one lap meets the next or where another motion takes its
 * place.
 */
export class Walk {
  readonly loop: Loop;
  #placement: Placement = HERE;
  /** Where the lap before this one was placed, while it fades. */
  #before: Placement | null = null;
  readonly #pose: Float32Array;
  readonly #other: Float32Array;

  /** `whole`: a lap takes in every frame, however badly the ends meet. */
  constructor(
    readonly motion: Motion,
    whole = false,
  ) {
    this.loop = whole ? wholeLoop(motion) : findLoop(motion);
    this.#pose = new Float32Array(motion.nodes * 3);
    this.#other = new Float32Array(motion.nodes * 3);
  }

  /** The next lap begins where this one ends. */
  lap(): void {
    this.#before = this.#placement;
    this.#placement = chain(this.loop.placement, this.#placement);
  }

  /** Back to where the motion itself says. */
  settle(): void {
    this.#before = null;
  }

  /** Stands where `pose` (the same figure, from another motion) stands now. */
  standAt(frame: number, pose: Float32Array): void {
    this.#before = null;
    this.#placement = placeOnto(poseAt(this.motion, frame, HERE, this.#pose), pose);
  }

  at(frame: number): Float32Array {
    poseAt(this.motion, frame, this.#placement, this.#pose);
    if (this.#before && frame < FADE) {
      poseAt(this.motion, this.loop.end + frame, this.#before, this.#other);
      blendInto(this.#pose, this.#other, 1 - frame / FADE);
    }
    return this.#pose;
  }
}
