// Where a figure stands: the height of its ground, and what touches it.
import type { Motion } from "../engine/protocol";

/** From the lowest node, inside a foot, to the ground. */
export const SOLE = 0.03;

/** The height on which the figure stands: of the lowest node of each frame, the middle one. */
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
