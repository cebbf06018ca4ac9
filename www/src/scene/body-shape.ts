// The thickness of the capsules of a figure, from the names of joints and the lengths of bones.
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
  /** The right and the left node whose line is the wide side of a trunk. */
  across: [number, number] | null;
}

export interface Ball {
  node: number;
  radius: number;
  joint: number;
  /** The ball of a head is shifted towards this node. */
  towards: number | null;
}

export interface Shape {
  capsules: Capsule[];
  balls: Ball[];
}

/**
 * Radii at the start and end of a bone, for a body of 1.7 m, by the name of its joint. The first match
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

/** Metres. A root this near the ground is no hip, and a bone this long from it is no bone of a body. */
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
  // Some skeletons have their root on the ground: the bone from there to the body is not drawn.
  const isOnGround = (node: number) =>
    figure.nodes[node]!.parent === null && pose[3 * node + 1]! < lowest + NEAR_GROUND;
  figure.nodes.forEach(({ parent }, node) => {
    if (parent === null) return;
    const joint = figure.nodes[parent]!.joint;
    const long = length(node, parent);
    if (long < 1e-3 || (long > LONGEST_HIP && isOnGround(parent))) return;
    const name = joints[joint] ?? "";
    let [r0, r1] = radii(name, long);
    // Short bones of limbs must not become balls.
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
  // Bones of the trunk continue each other without an edge.
  const trunk = capsules.filter(({ across }) => across !== null);
  for (const capsule of trunk) capsule.r1 = trunk.find(({ from }) => from === capsule.to)?.r0 ?? capsule.r1;
  // Bones from the trunk to hip and shoulder joints are thin enough to be covered by the trunk.
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

/** The ball of the head; null if no joint is named so. */
function headOf(figure: Figure, joints: readonly string[], pose: Float32Array): Ball | null {
  const isHead = (joint: number) => /head/i.test(joints[joint] ?? "");
  const node = figure.nodes.findIndex(({ joint, endSite }) => !endSite && isHead(joint));
  if (node < 0) return null;
  const joint = figure.nodes[node]!.joint;
  const end = figure.nodes.findIndex(({ parent, endSite }) => parent === node && endSite);
  const towards = end >= 0 && Math.abs(pose[3 * end + 1]! - pose[3 * node + 1]!) > 0.02 ? end : null;
  return { node, radius: 0.1, joint, towards };
}
