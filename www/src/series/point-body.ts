// A body of points: the columns NAME.x, NAME.y and NAME.z of a table, joined by bones.
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import type { SeriesInfo } from "../engine/series-protocol";

/** A column of a coordinate: the name of its point, and the axis. */
const COORDINATE = /^(.+)[ _.:-]([xyz])$/i;
/** Columns that a model of a body was rolled out to: `NAME.x` is there a part of a rotation, not a place. */
const ROTATIONS = /\.yaw_rate$/;
/** A figure has at least this many points. */
const LEAST_POINTS = 4;
/** A bone keeps its length. Columns of other things, such as forces, change theirs by more than this share. */
const MOST_CHANGE = 0.25;
/** What a length counts beside its deviation, in the choice of the bones. */
const NEARNESS = 0.05;
/** Rows that are enough to find the bones. */
const ROWS = 60;
/** Metres of the longest side of the figure. */
const HEIGHT = 1.7;
const UPPER = /head|nose|eye|ear|mouth|neck/i;
const LOWER = /foot|ankle|toe|heel/i;
const MIDDLE = /pelvis|hips$|^hip$|root/i;

/** A point, and the places of its coordinates among the columns. */
interface Point {
  name: string;
  at: [number, number, number];
}

/** The axis that points up: 0 for x to 2 for z. */
interface Up {
  axis: number;
  sign: 1 | -1;
}

export interface PointBody {
  figure: Figure;
  joints: string[];
  parts: PartSpec[];
  points: readonly Point[];
  up: Up;
  /** Metres for a unit of the table. */
  scale: number;
}

/** The points of which all three coordinates are columns. */
export function pointsOf(columns: readonly string[]): Point[] {
  const found = new Map<string, [number, number, number]>();
  columns.forEach((column, place) => {
    const [, name = "", axis = ""] = COORDINATE.exec(column) ?? [];
    if (!name) return;
    const at = found.get(name) ?? [-1, -1, -1];
    at["xyz".indexOf(axis.toLowerCase())] = place;
    found.set(name, at);
  });
  return [...found].filter(([, at]) => !at.includes(-1)).map(([name, at]) => ({ name, at }));
}

/** A few rows of the coordinates of each point, for the search of the bones [rows][points][3]. */
function someRows(points: readonly Point[], values: Float64Array, width: number): number[][][] {
  const rows = Math.floor(values.length / width);
  const step = Math.max(1, Math.ceil(rows / ROWS));
  const chosen = Array.from({ length: Math.ceil(rows / step) }, (_, i) => i * step * width);
  return chosen.map((row) => points.map(({ at }) => at.map((place) => values[row + place] ?? 0)));
}

const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Mean and standard deviation of the distance of two points. */
function distanceOf(rows: readonly number[][][], a: number, b: number): { mean: number; deviation: number } {
  const all = rows.map((row) => {
    const [from, to] = [row[a]!, row[b]!];
    return Math.hypot(from[0]! - to[0]!, from[1]! - to[1]!, from[2]! - to[2]!);
  });
  const middle = mean(all);
  return { mean: middle, deviation: Math.sqrt(mean(all.map((one) => (one - middle) ** 2))) };
}

/** The parent of each point in the tree of least cost (Prim 1957); null for the first point, the root. */
function leastTree(points: number, cost: (a: number, b: number) => number): (number | null)[] {
  const parents: (number | null)[] = Array(points).fill(null);
  const costs: number[] = Array(points).fill(Infinity);
  const open = new Set(Array.from({ length: points }, (_, point) => point));
  for (let next = 0; open.size > 0; ) {
    open.delete(next);
    for (const point of open) {
      const own = cost(next, point);
      if (own < costs[point]!) [parents[point], costs[point]] = [next, own];
    }
    next = [...open].sort((a, b) => costs[a]! - costs[b]!)[0] ?? next;
  }
  return parents;
}

/**
 * The parent of each point along the bones; null for the first point, the root. A bone keeps its length, up to
 * the errors of the measurement: the median deviation in the tree of least deviations. Of the pairs of points
 * that keep their distance, the nearest are joined. Null if the bones do not keep their lengths.
 */
function bonesOf(rows: readonly number[][][], points: number): (number | null)[] | null {
  const all = Array.from({ length: points }, (_, a) =>
    Array.from({ length: points }, (_, b) => distanceOf(rows, a, b)),
  );
  const lengths = (parents: (number | null)[]) =>
    parents.flatMap((parent, point) => (parent === null ? [] : [all[parent]![point]!]));
  const rigid = lengths(leastTree(points, (a, b) => all[a]![b]!.deviation));
  const error = rigid.map(({ deviation }) => deviation).sort((a, b) => a - b)[rigid.length >> 1] ?? 0;
  const parents = leastTree(points, (a, b) => {
    const { mean, deviation } = all[a]![b]!;
    return Math.max(0, deviation - error) + NEARNESS * mean;
  });
  const changes = lengths(parents).map(({ mean, deviation }) => deviation / (mean || 1));
  return mean(changes) > MOST_CHANGE ? null : parents;
}

/** The mean of each coordinate of the points whose names fit. */
function placeOf(rows: readonly number[][][], points: readonly Point[], names: RegExp): number[] | null {
  const chosen = [...points.keys()].filter((point) => names.test(points[point]!.name));
  if (chosen.length === 0) return null;
  return [0, 1, 2].map((k) => mean(rows.map((row) => mean(chosen.map((point) => row[point]![k]!)))));
}

/** The mean over the rows of the largest distance of two points along each axis. */
const sizesOf = (rows: readonly number[][][]): number[] =>
  [0, 1, 2].map((k) =>
    mean(rows.map((row) => Math.max(...row.map((at) => at[k]!)) - Math.min(...row.map((at) => at[k]!)))),
  );

/** From the feet to the head, by their names; without such names along the longest side. */
function upOf(rows: readonly number[][][], points: readonly Point[]): Up {
  const [head, feet] = [placeOf(rows, points, UPPER), placeOf(rows, points, LOWER)];
  const along = head && feet ? head.map((value, k) => value - feet[k]!) : sizesOf(rows);
  const axis = along.reduce((best, value, k) => (Math.abs(value) > Math.abs(along[best]!) ? k : best), 0);
  return { axis, sign: along[axis]! < 0 ? -1 : 1 };
}

/** The point of the hips by its name; else the one with the least mean distance from all. */
function rootOf(rows: readonly number[][][], points: readonly Point[]): number {
  const named = points.findIndex(({ name }) => MIDDLE.test(name));
  if (named >= 0) return named;
  const all = [...points.keys()];
  const far = all.map((a) => mean(all.map((b) => distanceOf(rows, a, b).mean)));
  return far.indexOf(Math.min(...far));
}

/** The body that the columns of a model describe, from values [rows x columns]; null: they are no body. */
export function pointBody(
  { columns, parts }: Pick<SeriesInfo, "columns" | "parts">,
  values: Float64Array,
): PointBody | null {
  const found = pointsOf(columns);
  if (found.length < LEAST_POINTS || columns.some((column) => ROTATIONS.test(column))) return null;
  const seen = someRows(found, values, columns.length);
  if (seen.length === 0) return null;
  const root = rootOf(seen, found);
  // The figure places motions by its first node.
  const points = [found[root]!, ...found.filter((_, point) => point !== root)];
  const rows = someRows(points, values, columns.length);
  const parents = bonesOf(rows, points.length);
  const size = Math.max(...sizesOf(rows));
  if (!parents || size <= 0) return null;
  return {
    figure: { nodes: parents.map((parent, joint) => ({ joint, parent, endSite: false })) },
    // Without names of joints all bones have the same form.
    joints: points.map(() => ""),
    parts: parts.map(({ name, joints: places }) => ({
      name,
      joints: [...points.keys()].filter((point) => places.includes(points[point]!.at[0])),
    })),
    points,
    up: upOf(rows, points),
    scale: HEIGHT / size,
  };
}

/** The coordinates with y up: a turn, which mirrors nothing. */
function upright([x, y, z]: readonly [number, number, number], { axis, sign }: Up): [number, number, number] {
  if (axis === 0) return [-sign * y, sign * x, z];
  if (axis === 1) return [x, sign * y, sign * z];
  return [x, sign * z, -sign * y];
}

/** Values [rows x columns] as a motion of the body. */
export function motionOf(
  { points, up, scale }: PointBody,
  values: Float64Array,
  width: number,
  frameTime: number,
): Motion {
  const frames = Math.floor(values.length / width);
  const positions = new Float32Array(frames * points.length * 3);
  for (let frame = 0; frame < frames; frame++)
    points.forEach(({ at }, point) => {
      const [x, y, z] = at.map((place) => scale * (values[frame * width + place] ?? 0));
      positions.set(upright([x!, y!, z!], up), 3 * (frame * points.length + point));
    });
  return { positions, frames, nodes: points.length, frameTime };
}
