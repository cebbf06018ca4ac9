// Poses between frames, the placement of a motion on the ground, and its loop. Geometry only.
import type { Motion } from "../engine/protocol";

/** A turn about the vertical axis followed by a shift on the ground. */
export interface Placement {
  yaw: number;
  x: number;
  z: number;
}

export const HERE: Placement = { yaw: 0, x: 0, z: 0 };

/** The place of a node, shifted by metres, from the root (node 0). */
export function fromRoot(
  pose: Float32Array,
  node: number,
  by: readonly [number, number, number],
): [number, number, number] {
  const along = (axis: 0 | 1 | 2) => (pose[3 * node + axis] ?? 0) - (pose[axis] ?? 0) + by[axis];
  return [along(0), along(1), along(2)];
}

/** A displacement on the stage in the axes of a motion before its placement. */
export function turnedBack(
  { yaw }: Placement,
  [x, y, z]: readonly [number, number, number],
): [number, number, number] {
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  return [c * x - s * z, y, s * x + c * z];
}

/** The placed pose [nodes x 3] at a frame, which need not be whole. */
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

/** The placement of `pose` with the same root (node 0) as `target`, and the least squared distance to it. */
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

/** Mean distance of the nodes of two motions [frames], metres, with equal roots and headings. */
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

/** The placement `first`, followed by `then`. */
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

/** The largest distance between the same node of two motions at the same time, in metres. */
export function largestDistance({ positions: a }: Motion, { positions: b }: Motion): number {
  let largest = 0;
  for (let i = 0; i < a.length; i += 3)
    largest = Math.max(largest, Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!));
  return largest;
}

/** The squared distance between a frame of a motion and a pose, with equal roots and headings. */
export function distanceTo(motion: Motion, frame: number, pose: Float32Array): number {
  const own = poseAt(motion, frame, HERE, new Float32Array(motion.nodes * 3));
  return distance(poseAt(motion, frame, placeOnto(own, pose), own), pose);
}

export interface Loop {
  /** The frame from which the motion continues as from frame 0. */
  end: number;
  /** The placement of frame 0 on frame `end`. */
  placement: Placement;
}

/** Frames over which one lap fades into the next. */
export const FADE = 6;

/** The loop over all frames. */
function wholeLoop(motion: Motion): Loop {
  const pose = (frame: number) => poseAt(motion, frame, HERE, new Float32Array(motion.nodes * 3));
  const last = motion.frames - 1;
  return { end: last, placement: last > 0 ? placeOnto(pose(0), pose(last)) : HERE };
}

/** The loop to the frame of the last two seconds that is most similar to frame 0 in pose and movement. */
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

/** Plays a motion lap after lap, without a jump between laps or when another motion replaces it. */
export class Walk {
  readonly loop: Loop;
  #placement: Placement = HERE;
  /** The placement of the lap before, while that lap fades. */
  #before: Placement | null = null;
  readonly #pose: Float32Array;
  readonly #other: Float32Array;

  /** `whole`: a lap has all frames, however different the ends are. */
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

  /** Back to the places of the motion itself. */
  resetPlacement(): void {
    this.#before = null;
  }

  /** Places frame `frame` on `pose`, which belongs to another motion of the same figure. */
  alignWith(frame: number, pose: Float32Array): void {
    this.#before = null;
    this.#placement = placeOnto(poseAt(this.motion, frame, HERE, this.#pose), pose);
  }

  /** A displacement on the stage in the axes of the motion before its placement. */
  turnedBack(by: readonly [number, number, number]): [number, number, number] {
    return turnedBack(this.#placement, by);
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
