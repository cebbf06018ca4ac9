// The place of each symbol of the equations on the page.
import type { MethodWords } from "../words/en/method";
import type { SYMBOLS } from "./equations";

export type SymbolRow =
  | { symbol: Shown; place: string }
  /** No place shows the symbol. */
  | { symbol: Exclude<keyof typeof SYMBOLS, Shown>; place: null };
type Shown = keyof MethodWords["symbols"]["there"];

export const SYMBOL_ROWS: SymbolRow[] = [
  { symbol: "parts", place: "parts" },
  { symbol: "frames", place: "length" },
  { symbol: "pose", place: "stage" },
  { symbol: "latent", place: "latents" },
  { symbol: "dimensions", place: "latent dimensions" },
  { symbol: "history", place: null },
  { symbol: "order", place: "order" },
  { symbol: "expert", place: "reading" },
  { symbol: "coupling", place: "couplings" },
  { symbol: "weight", place: "couplings" },
  { symbol: "dynamicsPoints", place: "points" },
  { symbol: "dynamicsCount", place: "dynamics points" },
  { symbol: "poseMap", place: null },
  { symbol: "posePoints", place: "points" },
  { symbol: "poseCount", place: "pose points" },
  { symbol: "noise", place: null },
  { symbol: "lengths", place: null },
  { symbol: "bound", place: "train" },
];
