// The positions of nodes, bones and arrows in the body map, in the units of its viewBox.
import type { ModelInfo, Motion } from "../engine/protocol";
import { HERE, poseAt } from "../scene/motion";
import { partOfJoints } from "../scene/part-of-joints";

export const WIDTH = 170;
export const HEIGHT = 190;
/** Radius of a node. */
export const NODE = 11;

export interface Spot {
  x: number;
  y: number;
}

/** A body from the front: a spot for each part, and the bones behind them. */
export interface Body {
  spots: Spot[];
  bones: { a: Spot; b: Spot; part: number }[];
}

/** Frames between the two poses that define the heading of the body. */
const HEADING_FRAMES = 45;

/** The first pose from the front, and a spot near the middle of each part. */
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

/** The line of an arrow, and the spot in its middle. */
export interface Arrow {
  path: string;
  middle: Spot;
}

/** An arc between the rims of two nodes, bent so that the arrows of both directions do not overlap. */
export function bowBetween(a: Spot, b: Spot): Arrow {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const bow = Math.min(26, 0.32 * length);
  const bend = { x: (a.x + b.x) / 2 - bow * uy * 1.6, y: (a.y + b.y) / 2 + bow * ux * 1.6 };
  const rim = (at: Spot, away: number) => {
    const [vx, vy] = [bend.x - at.x, bend.y - at.y];
    const size = Math.hypot(vx, vy) || 1;
    return { x: at.x + (away * vx) / size, y: at.y + (away * vy) / size };
  };
  const from = rim(a, NODE + 1);
  const to = rim(b, NODE + 5);
  return {
    path: `M${text(from)}Q${text(bend)} ${text(to)}`,
    middle: { x: (from.x + 2 * bend.x + to.x) / 4, y: (from.y + 2 * bend.y + to.y) / 4 },
  };
}

/** A loop at the outer side of a node. */
export function loopAt({ x, y }: Spot): Arrow {
  const side = x < WIDTH / 2 - 1 ? -1 : 1;
  const at = (angle: number, away: number): Spot => ({
    x: x + side * away * Math.cos(angle),
    y: y - away * Math.sin(angle),
  });
  const rim = NODE + 1;
  const [from, up, down, to] = [at(0.75, rim), at(0.62, 46), at(-0.62, 46), at(-0.62, rim + 5)];
  const middle = (along: "x" | "y") => (from[along] + 3 * up[along] + 3 * down[along] + to[along]) / 8;
  return {
    path: `M${text(from)}C${text(up)} ${text(down)} ${text(to)}`,
    middle: { x: middle("x"), y: middle("y") },
  };
}

const text = ({ x, y }: Spot): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
