// How thick the capsules of a figure are. BVH files have no flesh: names say most, bone lengths the rest.
import type { Figure } from "../engine/protocol";

export interface Capsule {
  /** The nodes at both ends. */
  from: number;
  to: number;
  length: number;
  /** Radii at both ends, metres. */
  r0: number;
  r1: number;
  /** The joint that turns this bone. */
  joint: number;
  /** Right and left node of the body here: across these a trunk is wider than it is deep. */
  across: [number, number] | null;
}

export interface Ball {
  node: number;
  radius: number;
  joint: number;
  /** Shifts the ball towards this node, which a head needs. */
  towards: number | null;
}

export interface Shape {
  capsules: Capsule[];
  balls: Ball[];
}

/**
 * Radii at the bone's start and end for a body of 1.7 m, by the name of the joint that turns it. First match
 * counts.
 */
const FLESH: [RegExp, number, number][] = [
  [/thumb|index|middle|ring|pinky|finger/, 0.013, 0.01],
  [/hand|wrist/, 0.026, 0.018],
  [/fore_?arm|lower_?arm|elbow/, 0.036, 0.026],
  [/collar|clavicle|shoulder(?!.*arm)/, 0.045, 0.045],
  [/arm/, 0.046, 0.036],
  [/toe|ball/, 0.03, 0.024],
  [/foot|ankle/, 0.038, 0.031],
  [/up_?leg|upper_?leg|thigh|(left|right|[lr]_?)_?hip$/, 0.078, 0.052],
  [/leg|knee|shin|calf|tibia/, 0.054, 0.036],
  [/head/, 0.05, 0.05],
  [/neck/, 0.05, 0.047],
  [/hips?$|pelvis|root/, 0.085, 0.08],
  [/spine|chest|torso|back|abdomen|waist|trunk/, 0.09, 0.098],
];

const TRUNK = /^(?!.*(left|right)).*(hips$|pelvis|root|spine|chest|torso|back|abdomen|waist|trunk)/i;

const RIGHT = /[Rr]ight|RIGHT|(^|[_:. ])[Rr](?=[A-Z_. ]|$)/;
const LEFT = /[Ll]eft|LEFT|(^|[_:. ])[Ll](?=[A-Z_. ]|$)/;

/** Metres: how near the ground a root is no hip, and how long a bone from it is no bone of a seated body. */
const NEAR_GROUND = 0.15;
const LONGEST_HIP = 0.35;

/** The first right and left node of a kind, by their names. */
function pairOf(figure: Figure, joints: readonly string[], kind: RegExp): [number, number] | null {
  const side = (pattern: RegExp) =>
    figure.nodes.findIndex(({ joint, endSite }) => {
      const name = joints[joint] ?? "";
      return !endSite && kind.test(name) && pattern.test(name);
    });
  const [right, left] = [side(RIGHT), side(LEFT)];
  return right >= 0 && left >= 0 ? [right, left] : null;
}

function radii(name: string, length: number): [number, number] {
  const plain = name.toLowerCase().replace(/^.*:/, "").replace(/\s+/g, "_");
  for (const [pattern, r0, r1] of FLESH) if (pattern.test(plain)) return [r0, r1];
  const radius = Math.min(0.06, Math.max(0.012, 0.16 * length));
  return [radius, radius * 0.8];
}

/** The capsules and balls of a figure, from its first pose [nodes x 3]. */
export function shapeOf(figure: Figure, joints: readonly string[], pose: Float32Array): Shape {
  const capsules: Capsule[] = [];
  const balls: Ball[] = [];
  const length = (a: number, b: number) =>
    Math.hypot(
      pose[3 * a]! - pose[3 * b]!,
      pose[3 * a + 1]! - pose[3 * b + 1]!,
      pose[3 * a + 2]! - pose[3 * b + 2]!,
    );
  const hips = pairOf(figure, joints, /up_?leg|upper_?leg|thigh|hip/i);
  const shoulders = pairOf(figure, joints, /arm|shoulder|collar/i);
  const lowest = figure.nodes.reduce((low, _, node) => Math.min(low, pose[3 * node + 1]!), Infinity);
  // Some skeletons have their root on the ground below the body: no flesh is between the two.
  const isOnGround = (node: number) =>
    figure.nodes[node]!.parent === null && pose[3 * node + 1]! < lowest + NEAR_GROUND;
  figure.nodes.forEach(({ parent }, node) => {
    if (parent === null) return;
    const joint = figure.nodes[parent]!.joint;
    const long = length(node, parent);
    if (long < 1e-3 || (long > LONGEST_HIP && isOnGround(parent))) return;
    const name = joints[joint] ?? "";
    let [r0, r1] = radii(name, long);
    // No thicker than long, or short bones become balls; the trunk may.
    if (r0 < 0.08) {
      const most = 0.45 * long;
      [r0, r1] = [Math.min(r0, Math.max(most, 0.01)), Math.min(r1, Math.max(most, 0.01))];
    }
    const across = TRUNK.test(name)
      ? /hip|pelvis|low|root/i.test(name)
        ? (hips ?? shoulders)
        : (shoulders ?? hips)
      : null;
    capsules.push({ from: parent, to: node, length: long, r0, r1, joint, across });
  });
  // Thin bones that leave the trunk sideways (hip and shoulder joints) stay thin enough to be covered by it.
  for (const capsule of capsules) {
    const parent = figure.nodes[capsule.from]!.parent;
    const outward = Math.abs(pose[3 * capsule.to]! - pose[3 * capsule.from]!) > 0.6 * capsule.length;
    if (parent === null && outward && capsule.r0 >= 0.08) [capsule.r0, capsule.r1] = [0.07, 0.07];
  }
  const head = headOf(figure, joints, pose);
  if (!head) return { capsules, balls };
  balls.push(head);
  return { capsules: capsules.filter(({ to }) => to !== head.towards), balls };
}

/** The head: the joint of that name with its end, or nothing where no joint has it. */
function headOf(figure: Figure, joints: readonly string[], pose: Float32Array): Ball | null {
  const isHead = (joint: number) => /head/i.test(joints[joint] ?? "");
  const node = figure.nodes.findIndex(({ joint, endSite }) => !endSite && isHead(joint));
  if (node < 0) return null;
  const joint = figure.nodes[node]!.joint;
  const end = figure.nodes.findIndex(({ parent, endSite }) => parent === node && endSite);
  const towards = end >= 0 && Math.abs(pose[3 * end + 1]! - pose[3 * node + 1]!) > 0.02 ? end : null;
  return { node, radius: 0.1, joint, towards };
}
