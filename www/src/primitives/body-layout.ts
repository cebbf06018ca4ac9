// The positions of nodes and bones in the body map, in the units of its viewBox.
import type { ModelInfo, Motion } from "../engine/protocol";
import { HERE, poseAt } from "../scene/motion";
import { partOfJoints } from "../scene/joints";

export const WIDTH = 170;
export const HEIGHT = 190;
/** Radius of a node. */
export const NODE = 11;

export interface Spot {
  x: number;
  y: number;
}

/** A body from behind: a spot for each part, and the bones behind them. */
export interface Body {
  spots: Spot[];
  bones: { a: Spot; b: Spot; part: number }[];
}

/** Frames between the two poses that define the heading of the body. */
const HEADING_FRAMES = 45;

/** The first pose from behind, so that its left is at the left, and a spot near the middle of each part. */
export function bodyOf(
  { figure, joints, parts }: Pick<ModelInfo, "figure" | "joints" | "parts">,
  motion: Motion,
): Body {
  const pose = pointsAt(motion, 0);
  const later = pointsAt(motion, Math.min(motion.frames - 1, HEADING_FRAMES));
  const [root = ORIGIN] = pose;
  const [goal = ORIGIN] = later;
  const heading = Math.atan2(goal.x - root.x, goal.z - root.z);
  const scale = (HEIGHT - 30) / Math.max(...pose.map(({ y }) => y), 0.1);
  const flat = pose.map(({ x, y, z }): Spot => {
    const sideways = (x - root.x) * Math.cos(heading) - (z - root.z) * Math.sin(heading);
    return { x: WIDTH / 2 - scale * sideways, y: HEIGHT - 14 - scale * y };
  });
  const part = partOfJoints(joints.length, parts);
  const bones = figure.nodes.flatMap(({ parent }, node) => {
    const [a, b] = [parent === null ? undefined : flat[parent], flat[node]];
    const joint = parent === null ? undefined : figure.nodes[parent]?.joint;
    return a && b && joint !== undefined ? [{ a, b, part: part[joint] ?? 0 }] : [];
  });
  const middles = parts.map((_, index) =>
    middle(flat.filter((_, node) => part[figure.nodes[node]?.joint ?? -1] === index)),
  );
  return { spots: drawApart(middles), bones };
}

const ORIGIN = { x: 0, y: 0, z: 0 };

/** The nodes of a motion at a frame. */
function pointsAt(motion: Motion, frame: number): { x: number; y: number; z: number }[] {
  const pose = poseAt(motion, frame, HERE, new Float32Array(motion.nodes * 3));
  return Array.from({ length: motion.nodes }, (_, node) => {
    const [x = 0, y = 0, z = 0] = pose.subarray(3 * node);
    return { x, y, z };
  });
}

function middle(spots: readonly Spot[]): Spot {
  const count = Math.max(1, spots.length);
  const sum = spots.reduce((sum, { x, y }) => ({ x: sum.x + x, y: sum.y + y }), { x: 0, y: 0 });
  return { x: sum.x / count, y: sum.y / count };
}

/** Moves nodes away from each other until no two overlap, within the map. */
export function drawApart(spots: readonly Spot[]): Spot[] {
  const apart = spots.map(({ x, y }) => ({ x, y }));
  const least = 52;
  for (let round = 0; round < 60; round++) {
    for (const [i, a] of apart.entries()) {
      for (const b of apart.slice(i + 1)) {
        let [dx, dy] = [b.x - a.x, b.y - a.y];
        const gap = Math.hypot(dx, dy);
        if (gap >= least) continue;
        if (gap < 1e-3) [dx, dy] = [Math.cos(i), Math.sin(i)];
        const push = (0.5 * (least - gap)) / (gap < 1e-3 ? 1 : gap);
        a.x -= push * dx;
        a.y -= push * dy;
        b.x += push * dx;
        b.y += push * dy;
      }
    }
    for (const spot of apart) {
      spot.x = Math.min(WIDTH - 34, Math.max(34, spot.x));
      spot.y = Math.min(HEIGHT - 26, Math.max(26, spot.y));
    }
  }
  return apart;
}
