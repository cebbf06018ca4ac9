// What the hands and feet of a motion do, measured on its positions.
import type { LibraryInfo } from "../../engine/library-protocol";
import type { Motion } from "../../engine/protocol";
import { nodeOfJoint } from "../../scene/joint-node";

export interface HandsAndFeet {
  /** The mean height of the hands above the hips, in metres. */
  height: number;
  /** The mean speed of the hands against the hips, in metres a second. */
  speed: number;
  /** How often a foot overtakes the other one, in steps a second; 0 for a body that stays in its place. */
  steps: number;
}

/** Metres a second of a root that is slower than any walk. */
const SLOWEST_WALK = 0.3;

/** The node of the joint whose name ends like this; null: the body has no such joint. */
function nodeOf({ joints, figure }: Pick<LibraryInfo, "joints" | "figure">, end: RegExp): number | null {
  const joint = joints.findIndex(({ name }) => end.test(name));
  const node = nodeOfJoint(figure, joint);
  return joint < 0 || node < 0 ? null : node;
}

/** Null for a body without two hands and two feet whose names say so. */
export function measureHandsAndFeet(
  info: Pick<LibraryInfo, "joints" | "figure">,
  { positions, frames, nodes, frameTime }: Motion,
): HandsAndFeet | null {
  const [left, right] = [nodeOf(info, /left_?hand$/i), nodeOf(info, /right_?hand$/i)];
  const [leftFoot, rightFoot] = [nodeOf(info, /left_?foot$/i), nodeOf(info, /right_?foot$/i)];
  if (left === null || right === null || leftFoot === null || rightFoot === null || frames < 2) return null;
  const at = (frame: number, node: number, axis: number) => positions[3 * (frame * nodes + node) + axis] ?? 0;
  /** The place of a node against the root of the body. */
  const place = (frame: number, node: number) =>
    [0, 1, 2].map((axis) => at(frame, node, axis) - at(frame, 0, axis));
  const hands = [left, right];
  let [height, path, steps, before] = [0, 0, 0, 0];
  for (let frame = 0; frame < frames; frame++) {
    for (const hand of hands) height += place(frame, hand)[1]! / (hands.length * frames);
    if (frame === 0) continue;
    for (const hand of hands) {
      const [now, then] = [place(frame, hand), place(frame - 1, hand)];
      path += Math.hypot(...now.map((x, axis) => x - then[axis]!)) / hands.length;
    }
    // The distance between the feet along the way of the root.
    const [x, z] = [at(frame, 0, 0) - at(frame - 1, 0, 0), at(frame, 0, 2) - at(frame - 1, 0, 2)];
    const apart = (axis: number) => at(frame, leftFoot, axis) - at(frame, rightFoot, axis);
    const ahead = x * apart(0) + z * apart(2);
    if (ahead * before < 0) steps += 1;
    if (ahead !== 0) before = ahead;
  }
  const seconds = (frames - 1) * frameTime;
  const way = [0, 2].map((axis) => at(frames - 1, 0, axis) - at(0, 0, axis));
  if (Math.hypot(...way) < SLOWEST_WALK * seconds) steps = 0;
  return { height, speed: path / seconds, steps: steps / seconds };
}
