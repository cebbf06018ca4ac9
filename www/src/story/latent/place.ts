// Places in the plane of a plot, along the first two axes of its projection.
import type { Plane } from "../../latents/plane";
import { project, type Projection } from "../../latents/projection";

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
