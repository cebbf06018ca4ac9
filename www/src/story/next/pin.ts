// How good a pin is, measured at sampled futures: places in the plane of the plot.

export interface PinScore {
  /** The distance of the pin from the mean of the futures, in standard deviations of the futures. */
  deviations: number;
  /** The number of futures that are further from the mean than the pin. */
  beaten: number;
  futures: number;
}

/** Mean and covariance of places [n x 2]. */
export interface PlaceSpread {
  mean: [number, number];
  covariance: [xx: number, xy: number, yy: number];
}

export function spreadOf(places: readonly (readonly [number, number])[]): PlaceSpread {
  const n = places.length;
  const mean: [number, number] = [0, 0];
  for (const [x, y] of places) {
    mean[0] += x / n;
    mean[1] += y / n;
  }
  const covariance: PlaceSpread["covariance"] = [0, 0, 0];
  for (const [x, y] of places) {
    const [dx, dy] = [x - mean[0], y - mean[1]];
    covariance[0] += (dx * dx) / (n - 1);
    covariance[1] += (dx * dy) / (n - 1);
    covariance[2] += (dy * dy) / (n - 1);
  }
  return { mean, covariance };
}

/** The distance from the mean in standard deviations in the direction of the place. */
export function deviationsFrom(
  { mean, covariance: [a, b, c] }: PlaceSpread,
  [x, y]: readonly [number, number],
): number {
  const [dx, dy] = [x - mean[0], y - mean[1]];
  return Math.sqrt((c * dx * dx - 2 * b * dx * dy + a * dy * dy) / (a * c - b * b));
}

export function scorePin(
  places: readonly (readonly [number, number])[],
  pin: readonly [number, number],
): PinScore {
  const spread = spreadOf(places);
  const deviations = deviationsFrom(spread, pin);
  const beaten = places.filter((place) => deviationsFrom(spread, place) > deviations).length;
  return { deviations, beaten, futures: places.length };
}
