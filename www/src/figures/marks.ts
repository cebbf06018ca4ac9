// Marks of points in figures: seven shapes that differ without colours too.
import { svg } from "lit";

export type MarkShape = "circle" | "square" | "triangle" | "wedge" | "diamond" | "cross" | "plus";

/** Half width of a mark for type of size 1. */
export const MARK_SIZE = 0.38;

/** Outlines around (0, 0) of the same visual size, for a size of 1. */
const OUTLINES: Record<MarkShape, [number, number][]> = {
  circle: [],
  square: [
    [-0.86, -0.86],
    [0.86, -0.86],
    [0.86, 0.86],
    [-0.86, 0.86],
  ],
  triangle: [
    [0, -1.16],
    [1.1, 0.8],
    [-1.1, 0.8],
  ],
  wedge: [
    [0, 1.16],
    [1.1, -0.8],
    [-1.1, -0.8],
  ],
  diamond: [
    [0, -1.25],
    [1.25, 0],
    [0, 1.25],
    [-1.25, 0],
  ],
  cross: turned(45),
  plus: turned(0),
};

/** A plus with thick arms, rotated. */
function turned(degrees: number): [number, number][] {
  const arm = 1.2;
  const half = 0.36;
  const corners: [number, number][] = [
    [-half, -arm],
    [half, -arm],
    [half, -half],
    [arm, -half],
    [arm, half],
    [half, half],
    [half, arm],
    [-half, arm],
    [-half, half],
    [-arm, half],
    [-arm, -half],
    [-half, -half],
  ];
  const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return corners.map(([x, y]) => [x * cos - y * sin, x * sin + y * cos]);
}

/** The outline of a mark around a point. */
export function markPath(shape: MarkShape, x: number, y: number, size: number): string {
  const at = (dx: number, dy: number) => `${(x + size * dx).toFixed(2)} ${(y + size * dy).toFixed(2)}`;
  if (shape === "circle") {
    const arc = `A${size} ${size} 0 1 1`;
    return `M${at(-1, 0)}${arc} ${at(1, 0)}${arc} ${at(-1, 0)}Z`;
  }
  return `M${OUTLINES[shape].map(([dx, dy]) => at(dx, dy)).join("L")}Z`;
}

export function markAt(shape: MarkShape, x: number, y: number, size: number) {
  return svg`<path class="dot" d=${markPath(shape, x, y, size)}></path>`;
}
