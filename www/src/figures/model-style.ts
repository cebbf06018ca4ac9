// The name, colour and mark of each kind of model in all figures. The colours are similar to those of Okabe
// and Ito. Any two differ for colour-blind people too, and each is visible on the light and the dark page.
import type { ModelKind, Rival } from "../engine/whole-protocol";
import { type MarkShape, markAt } from "./marks";
import { styled } from "../ui/styled";

interface Look {
  name: string;
  light: string;
  dark: string;
  mark: MarkShape;
}

export const LOOKS: Record<ModelKind, Look> = {
  vcgpdm: { name: "vCGPDM", light: "#075cb1", dark: "#639bdb", mark: "circle" },
  vgpdm: { name: "vGPDM", light: "#d26208", dark: "#f77320", mark: "square" },
  "map-gpdm": { name: "MAP GPDM", light: "#229878", dark: "#7dceb4", mark: "triangle" },
  "map-cgpdm": { name: "MAP CGPDM", light: "#97336c", dark: "#b25a7c", mark: "wedge" },
  tmp: { name: "TMP", light: "#2b3137", dark: "#f0f1f3", mark: "diamond" },
  "dmp-discrete": { name: "DMP (discrete)", light: "#614a00", dark: "#f8c535", mark: "cross" },
  "dmp-rhythmic": { name: "DMP (rhythmic)", light: "#9973dc", dark: "#7852d5", mark: "plus" },
};

/** Models of files of results only: grey. Their names tell them apart. */
const RIVALS: Record<Rival["model"], Look> = {
  promp: { name: "ProMP", light: "#6a7077", dark: "#9aa1a9", mark: "square" },
  ar: { name: "AR", light: "#6a7077", dark: "#9aa1a9", mark: "diamond" },
};

type Compared = ModelKind | Rival["model"];

const look = (kind: Compared): Look => ({ ...LOOKS, ...RIVALS })[kind];

/** `colour`: a CSS colour for both themes. */
export function modelStyle(kind: Compared): { name: string; colour: string; mark: MarkShape } {
  const { name, light, dark, mark } = look(kind);
  return { name, colour: `light-dark(${light}, ${dark})`, mark };
}

/** The style of an element with drawings in the colour of a model. */
export function inColour(kind: Compared) {
  return styled({ "--series": modelStyle(kind).colour });
}

/** The mark of a model around a point. */
export function modelMark(kind: Compared, x: number, y: number, size: number) {
  return markAt(look(kind).mark, x, y, size);
}
