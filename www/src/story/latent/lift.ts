// From a place in the plane of a plot back to the latent space: the plane does not say how near a point is.
import { project, type Projection } from "../../latents/projection";

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
