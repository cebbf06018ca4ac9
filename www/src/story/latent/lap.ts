// One lap of a rollout that repeats itself: the loop that a walk is.
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
