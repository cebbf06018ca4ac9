// Channels of a motion over time, read from the text of its BVH file. No DOM.
import type { JointInfo } from "../engine/protocol";
import { csv } from "../figures/csv";

/** A degree of freedom of a joint, with its column in each frame. */
export interface Channel {
  joint: string;
  channel: string;
  column: number;
  isAngle: boolean;
}

/** A motion's numbers [frames][channels], angles in degrees. */
export interface Recorded {
  frameTime: number;
  rows: number[][];
}

/** The channels of a body, in the order of a file's columns. */
export function channelsOf(joints: readonly JointInfo[]): Channel[] {
  const all = joints.flatMap(({ name, channels }) => channels.map((channel) => ({ joint: name, channel })));
  return all.map((channel, column) => ({
    ...channel,
    column,
    isAngle: channel.channel.endsWith("rotation"),
  }));
}

export function readMotion(bvh: string): Recorded {
  const [, motion = ""] = bvh.split(/^MOTION\s*$/m);
  const [, time = "", ...lines] = motion.trim().split(/\r?\n/);
  const rows = lines.map((line) => line.trim().split(/\s+/).map(Number));
  return { frameTime: Number(time.split(":")[1]), rows };
}

/** A channel in every frame. An angle beyond 180 degrees continues without a jump. */
export function courseOf({ rows }: Recorded, { column, isAngle }: Channel): number[] {
  let before: number | null = null;
  return rows.map((row) => {
    const value: number = row[column] ?? Number.NaN;
    const turns = isAngle && before !== null ? Math.round((before - value) / 360) : 0;
    before = value + 360 * turns;
    return before;
  });
}

/** Speeds in units a second: central differences, and one-sided differences at both ends. */
export function speedOf(course: readonly number[], frameTime: number): number[] {
  const last = course.length - 1;
  return course.map((_, t) => {
    const [from, to] = [Math.max(0, t - 1), Math.min(last, t + 1)];
    return to > from ? ((course[to] ?? 0) - (course[from] ?? 0)) / ((to - from) * frameTime) : 0;
  });
}

/** The plotted values as a table for a file: a row for each frame, two columns for each motion. */
export function plottedCsv(
  frameTime: number,
  motions: readonly { name: string; x: readonly number[] | null; y: readonly number[] }[],
  titles: { x: string; y: string },
): string {
  const frames = Math.max(0, ...motions.map(({ y }) => y.length));
  const header = motions.flatMap(({ name, x }) => [
    ...(x ? [`${name}: ${titles.x}`] : []),
    `${name}: ${titles.y}`,
  ]);
  const rows = Array.from({ length: frames }, (_, t) => [
    t,
    t * frameTime,
    ...motions.flatMap(({ x, y }) => [...(x ? [x[t] ?? null] : []), y[t] ?? null]),
  ]);
  return csv({ header: ["frame", "time (s)", ...header], rows });
}
