// Paths in the drawings of latent spaces.
import type { Plane } from "../../latents/plane";
import { project, type Projection } from "../../latents/projection";

export interface Lap {
  /** [frames x Q] */
  path: Float64Array;
  /** The frame of the rollout where the lap begins. */
  first: number;
  frames: number;
}

/** Frames of the shortest and of the longest lap. */
const SHORTEST = 15;
const LONGEST = 90;

/** The first lap in the second half of a path [frames x Q], where the start is forgotten. */
export function lapOf(path: Float64Array, dimensions: number): Lap {
  const frames = path.length / dimensions;
  const first = Math.floor(frames / 2);
  const longest = Math.min(LONGEST, frames - first - 1);
  const distance = (lag: number) => {
    let sum = 0;
    const compared = frames - first - longest;
    for (let i = first * dimensions; i < (first + compared) * dimensions; i++)
      sum += (path[i + lag * dimensions]! - path[i]!) ** 2;
    return sum / compared;
  };
  const lags = Array.from({ length: Math.max(1, longest - SHORTEST + 1) }, (_, i) => SHORTEST + i);
  const distances = lags.map(distance);
  const least = Math.min(...distances);
  const spread = Math.max(...distances) - least;
  // Two laps fit as well as one; the shortest is the lap.
  const fits = distances.findIndex(
    (value, i) => value <= least + 0.03 * spread && value <= (distances[i + 1] ?? Infinity),
  );
  const lag = lags[Math.max(0, fits)]!;
  return { path: path.slice(first * dimensions, (first + lag) * dimensions), first, frames: lag };
}

export type Place = [right: number, up: number];

/** Row `row` of latents [frames x Q] in the plane. */
export function placeOf(projection: Projection, latents: Float64Array, row: number): Place {
  const [right, up] = project(projection, latents, row, new Float64Array(3));
  return [right!, up!];
}

/** A place in pixels. */
export function pixelsAt(
  plane: Plane,
  { centre, axes, dimensions: q }: Projection,
  [right, up]: Place,
): [x: number, y: number] {
  const point = Float64Array.from({ length: q }, (_, a) => centre[a]! + right * axes[a]! + up * axes[q + a]!);
  const [x, y] = plane.place(point, 0);
  return [x, y];
}

/** The place at pixels. */
export function axesAt(
  plane: Plane,
  { centre, axes, dimensions: q }: Projection,
  x: number,
  y: number,
): Place {
  const [middleX, middleY] = plane.place(centre, 0);
  const step = plane.latentStep(x - middleX, y - middleY);
  const along = (axis: number) => step.reduce((sum, value, a) => sum + value * axes[axis * q + a]!, 0);
  return [along(0), along(1)];
}

/** Strokes rows `first` to `last` of a path [frames x Q]. */
export function strokePath(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  path: Float64Array,
  first: number,
  last: number,
): void {
  draw.beginPath();
  tracePath(draw, plane, path, first, last);
  draw.stroke();
}

/** Strokes the loop of a lap. */
export function strokeLoop(draw: CanvasRenderingContext2D, plane: Plane, { path, frames }: Lap): void {
  draw.beginPath();
  tracePath(draw, plane, path, 0, frames - 1);
  draw.closePath();
  draw.stroke();
}

export function tracePath(
  draw: CanvasPath,
  plane: Plane,
  path: Float64Array,
  first: number,
  last: number,
): void {
  for (let row = first; row <= last; row++) {
    const [x, y] = plane.place(path, row);
    draw.lineTo(x, y);
  }
}

/** Width of the mean of the path's depths, as a share of the cloud's reach. */
const WIDTH = 0.2;

/** The path of a plot on its three axes, [frames x 3]. */
export function projectPath(projection: Projection, path: Float64Array): Float64Array {
  const frames = path.length / projection.dimensions;
  const seen = new Float64Array(3 * frames);
  const at = new Float64Array(3);
  for (let t = 0; t < frames; t++) seen.set(project(projection, path, t, at), 3 * t);
  return seen;
}

/** The row of a projected path nearest to a place in the plane. */
export function nearestRow(seen: Float64Array, right: number, up: number): number {
  let best = 0;
  let least = Infinity;
  for (let t = 0; t < seen.length / 3; t++) {
    const away = (seen[3 * t]! - right) ** 2 + (seen[3 * t + 1]! - up) ** 2;
    if (away < least) [best, least] = [t, away];
  }
  return best;
}

/**
 * The point [Q] of the latent space at a place in the plane, given along the first two axes. Its depth is that
 * of the path near the place.
 */
export function lift(
  { centre, axes, reach, dimensions: q }: Projection,
  seen: Float64Array,
  right: number,
  up: number,
): Float64Array {
  const near = nearestRow(seen, right, up);
  const least = (seen[3 * near]! - right) ** 2 + (seen[3 * near + 1]! - up) ** 2;
  let [depth, total] = [0, 0];
  for (let t = 0; t < seen.length / 3; t++) {
    const away = (seen[3 * t]! - right) ** 2 + (seen[3 * t + 1]! - up) ** 2;
    const share = Math.exp((least - away) / (2 * (WIDTH * reach) ** 2));
    depth += share * seen[3 * t + 2]!;
    total += share;
  }
  const along = [right, up, depth / total];
  return Float64Array.from({ length: q }, (_, a) =>
    along.reduce((sum, step, axis) => sum + step * axes[axis * q + a]!, centre[a]!),
  );
}
