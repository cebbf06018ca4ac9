// The height of the ground under a figure, its feet, and the direction of its walk.
import type { Motion } from "../engine/protocol";

/** Metres from the lowest node, inside a foot, to the ground. */
export const SOLE = 0.03;
/** Metres from the ground to the middle of a figure, the centre of the picture. */
export const MIDDLE = 0.88;
/** Thickness of the flesh around the joints, metres. */
const FLESH = 0.1;
/** The share of the picture that texts and time line leave to the figure. */
const FREE = 0.9;
/** A walk has a direction if its first frames cover this distance in metres. */
const LEAST_WAY = 0.2;
const FIRST_FRAMES = 60;

/** The height of the ground: the median over the frames of the lowest node. */
export function floorOf({ positions, frames, nodes }: Motion): number {
  const lowest = new Float32Array(frames).fill(Infinity);
  for (let i = 0; i < frames * nodes; i++) {
    const frame = Math.floor(i / nodes);
    lowest[frame] = Math.min(lowest[frame]!, positions[3 * i + 1]!);
  }
  const middle = lowest.sort()[frames >> 1] ?? 0;
  return Number.isFinite(middle) ? middle : 0;
}

/** Nodes that come down to the ground. */
export function feetOf({ positions, frames, nodes }: Motion, floor: number): number[] {
  const lowest = new Float32Array(nodes).fill(Infinity);
  for (let t = 0; t < frames; t++) {
    for (let node = 0; node < nodes; node++) {
      lowest[node] = Math.min(lowest[node]!, positions[(t * nodes + node) * 3 + 1]!);
    }
  }
  return [...lowest.keys()].filter((node) => lowest[node]! < floor + 0.12).slice(0, 8);
}

/** Where a camera looks at a figure. */
export interface View {
  /** Metres from the ground to the centre of the picture. */
  middle: number;
  /** Metres from there to the camera. */
  distance: number;
}

/**
 * The view in which a camera sees the whole motion from every side, also raised hands. `slope`: the tangent
 * of half its vertical angle; `shift`: the share of the picture's height by which the centre is moved up or
 * down.
 */
export function viewOf(
  { positions, frames, nodes }: Motion,
  floor: number,
  { slope, aspect, shift = 0 }: { slope: number; aspect: number; shift?: number },
): View {
  let top = 2 * MIDDLE - FLESH;
  for (let at = 1; at < 3 * frames * nodes; at += 3) top = Math.max(top, positions[at]! - floor);
  const middle = (top + FLESH) / 2;
  const upright = slope * FREE * (1 - 2 * Math.abs(shift));
  let distance = 0;
  for (let t = 0; t < frames; t++) {
    const root = 3 * t * nodes;
    for (let at = root; at < root + 3 * nodes; at += 3) {
      const out = Math.hypot(positions[at]! - positions[root]!, positions[at + 2]! - positions[root + 2]!);
      const up = Math.abs(positions[at + 1]! - floor - middle);
      // A node near the camera looks larger; a node at the side needs the width.
      distance = Math.max(distance, out + (up + FLESH) / upright, (out + FLESH) / (slope * aspect * FREE));
    }
  }
  return { middle, distance };
}

/** The direction of the walk, seen from above, radians; 0 for a walk on the spot. */
export function headingOf({ positions, frames, nodes }: Motion): number {
  const end = Math.min(frames - 1, FIRST_FRAMES) * nodes * 3;
  const [dx, dz] = [positions[end]! - positions[0]!, positions[end + 2]! - positions[2]!];
  return Math.hypot(dx, dz) > LEAST_WAY ? Math.atan2(dx, dz) : 0;
}
