// Points as the paths of a drawing.

/** The map from points of a plane to a square drawing. */
export interface Frame {
  middle: [number, number];
  /** Pixels for one unit. */
  scale: number;
  side: number;
}

const MARGIN = 0.06;

/**
 * The map that shows all points [n x 2], row after row, with one scale for both axes. `margin`: the free share
 * of the drawing at each edge.
 */
export function frameOf(points: readonly number[], side: number, margin = MARGIN): Frame {
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
  return { middle: [middle(0), middle(1)], scale: extent > 0 ? (side * (1 - 2 * margin)) / extent : 1, side };
}

const tenth = (value: number) => Math.round(10 * value) / 10;

/** The place of a point in the drawing; y points up. */
export const placeIn = ({ middle, scale, side }: Frame, x: number, y: number): [number, number] => [
  tenth(side / 2 + scale * (x - middle[0])),
  tenth(side / 2 - scale * (y - middle[1])),
];

/** Points [n x 2], row after row, as one line. */
export function linePath(points: readonly number[], frame: Frame): string {
  const steps: string[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    steps.push(placeIn(frame, points[i]!, points[i + 1]!).join(" "));
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
  /** The value at the largest height of a curve; absent: the largest of the drawn values. */
  largest?: number;
}

/** Each column over time, one below the other, all on one scale. */
export function curvePaths({ values, columns, frames, width, height, largest }: Curves): string[] {
  const shown = values.slice(0, frames * columns);
  const most = largest ?? (shown.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1);
  const row = height / columns;
  // Curves may overlap their neighbours' rows a little.
  const scale = (0.8 * row) / most;
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
