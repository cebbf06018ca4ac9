/** A path is back on the loop within this distance, in radii of the loop. */
const NEAR = 0.1;

/**
 * Seconds until a path stays near the loop; null: it does not. `distances`: in radii, one for each frame; the first
 * is one frame after the start.
 */
export function backFrom(distances: Float64Array, frameTime: number): number | null {
  const last = distances.findLastIndex((distance) => !(distance <= NEAR));
  return last === distances.length - 1 ? null : (last + 2) * frameTime;
}
