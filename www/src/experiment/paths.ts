// Points as the paths of a drawing.

/** The map from points of a plane to a square drawing. */
export interface Frame {
  middle: [number, number];
  /** Pixels for one unit. */
  scale: number;
  side: number;
}

/** The free share of a drawing at each edge. */
const MARGIN = 0.06;

/** The map that shows all points [n x 2], row after row, with one scale for both axes. */
export function frameOf(points: readonly number[], side: number): Frame {
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  points.forEach((value, i) => {
    low[i % 2] = Math.min(low[i % 2]!, value);
    high[i % 2] = Math.max(high[i % 2]!, value);
  });
  const extent = Math.max(high[0]! - low[0]!, high[1]! - low[1]!);
  const middle = (q: 0 | 1) => (points.length > 0 ? (low[q]! + high[q]!) / 2 : 0);
  return { middle: [middle(0), middle(1)], scale: extent > 0 ? (side * (1 - 2 * MARGIN)) / extent : 1, side };
}

const tenth = (value: number) => Math.round(10 * value) / 10;

/** Points [n x 2], row after row, as one line; y points up. */
export function linePath(points: readonly number[], { middle, scale, side }: Frame): string {
  const steps: string[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const x = side / 2 + scale * (points[i]! - middle[0]);
    const y = side / 2 - scale * (points[i + 1]! - middle[1]);
    steps.push(`${tenth(x)} ${tenth(y)}`);
  }
  return steps.length > 0 ? `M${steps.join("L")}` : "";
}

export interface Curves {
  /** All frames [frames x columns], row after row. */
  values: readonly number[];
  columns: number;
  /** The number of drawn frames. */
  frames: number;
  width: number;
  height: number;
}

/** Each column over time, one below the other, all on one scale. */
export function curvePaths({ values, columns, frames, width, height }: Curves): string[] {
  const shown = values.slice(0, frames * columns);
  const largest = shown.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1;
  const row = height / columns;
  // Curves may overlap their neighbours' rows a little.
  const scale = (0.8 * row) / largest;
  return Array.from({ length: columns }, (_, column) => {
    const steps: string[] = [];
    for (let t = 0; (t + 1) * columns <= shown.length; t++) {
      steps.push(
        `${tenth((t / Math.max(1, frames - 1)) * width)} ${tenth((column + 0.5) * row - scale * shown[t * columns + column]!)}`,
      );
    }
    return `M${steps.join("L")}`;
  });
}
