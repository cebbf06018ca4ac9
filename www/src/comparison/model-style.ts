// One name, one colour and one mark a model, in every figure. The colours are near those of Okabe and Ito; lightness and hue are
// chosen so that any two differ also for colour-blind people, and that each stands out on the page, light and dark.
import type { ModelId } from "../engine/protocol";

export type Mark = "circle" | "square" | "triangle" | "wedge" | "diamond" | "cross" | "plus";

export interface ModelStyle {
  name: string;
  /** A CSS colour for both themes. */
  colour: string;
  mark: Mark;
}

interface Look {
  name: string;
  light: string;
  dark: string;
  mark: Mark;
}

export const LOOKS: Record<ModelId, Look> = {
  vcgpdm: { name: "vCGPDM", light: "#075cb1", dark: "#639bdb", mark: "circle" },
  vgpdm: { name: "vGPDM", light: "#d26208", dark: "#f77320", mark: "square" },
  "map-gpdm": { name: "MAP GPDM", light: "#229878", dark: "#7dceb4", mark: "triangle" },
  "map-cgpdm": { name: "MAP CGPDM", light: "#97336c", dark: "#b25a7c", mark: "wedge" },
  tmp: { name: "TMP", light: "#2b3137", dark: "#f0f1f3", mark: "diamond" },
  "dmp-discrete": { name: "DMP (discrete)", light: "#614a00", dark: "#f8c535", mark: "cross" },
  "dmp-rhythmic": { name: "DMP (rhythmic)", light: "#9973dc", dark: "#7852d5", mark: "plus" },
};

export function modelStyle(id: ModelId): ModelStyle {
  const { name, light, dark, mark } = LOOKS[id];
  return { name, colour: `light-dark(${light}, ${dark})`, mark };
}

/** Outlines about (0, 0) that look equally large, for a size of 1. */
const OUTLINES: Record<Mark, [number, number][]> = {
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

/** A plus with arms as thick as can still be told from a square. */
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

/** The path of a mark around a point. */
export function markPath(mark: Mark, x: number, y: number, size: number): string {
  const at = (dx: number, dy: number) => `${(x + size * dx).toFixed(2)} ${(y + size * dy).toFixed(2)}`;
  if (mark === "circle") {
    const arc = `A${size} ${size} 0 1 1`;
    return `M${at(-1, 0)}${arc} ${at(1, 0)}${arc} ${at(-1, 0)}Z`;
  }
  return `M${OUTLINES[mark].map(([dx, dy]) => at(dx, dy)).join("L")}Z`;
}
