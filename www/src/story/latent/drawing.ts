// Paths in the drawings of latent spaces.
import type { Plane } from "../../latents/plane";
import type { Lap } from "./lap";

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
