// The meaning of each symbol of the equations, and its place on the page.
import type { SYMBOLS } from "./equations";

export interface SymbolRow {
  symbol: keyof typeof SYMBOLS;
  meaning: string;
  /** The name of a place on the page and a description of it; absent: no place shows the symbol. */
  place?: string;
  there?: string;
}

export const SYMBOL_ROWS: SymbolRow[] = [
  {
    symbol: "parts",
    meaning: "parts of the body: j predicts i",
    place: "parts",
    there: "Parts: how the body is split",
  },
  { symbol: "frames", meaning: "frame, counted from 0", place: "length", there: "the time line" },
  {
    symbol: "pose",
    meaning: "the pose of part i: joint angles, and how the root moves",
    place: "stage",
    there: "the figure",
  },
  {
    symbol: "latent",
    meaning: "latent: the pose of part i in a few numbers",
    place: "latents",
    there: "the dot in its plot",
  },
  {
    symbol: "dimensions",
    meaning: "dimensions of a latent space",
    place: "latent dimensions",
    there: "Latent dimensions",
  },
  { symbol: "history", meaning: "the last p latents of part j" },
  { symbol: "order", meaning: "order of the dynamics", place: "order", there: "Frames of history" },
  {
    symbol: "expert",
    meaning: "expert: what part j predicts about part i",
    place: "reading",
    there: "as learned, or re-inferred",
  },
  {
    symbol: "coupling",
    meaning: "coupling variance: small means influential",
    place: "couplings",
    there: "the sliders",
  },
  {
    symbol: "weight",
    meaning: "weight of an expert, 0 to 1",
    place: "couplings",
    there: "the numbers under the sliders",
  },
  {
    symbol: "dynamicsPoints",
    meaning: "dynamics inducing points: histories, and what follows them",
    place: "points",
    there: "the arrows in the plots",
  },
  {
    symbol: "dynamicsCount",
    meaning: "how many of them each expert has",
    place: "dynamics points",
    there: "Dynamics points",
  },
  { symbol: "poseMap", meaning: "pose map: from latents to poses" },
  {
    symbol: "posePoints",
    meaning: "pose inducing points, and their poses",
    place: "points",
    there: "the diamonds in the plots",
  },
  {
    symbol: "poseCount",
    meaning: "how many of them each pose map has",
    place: "pose points",
    there: "Pose points",
  },
  { symbol: "noise", meaning: "variance of the noise of part i’s poses" },
  { symbol: "lengths", meaning: "squared lengthscale: how far apart two latents are still alike" },
  {
    symbol: "bound",
    meaning: "evidence lower bound, in nats",
    place: "train",
    there: "the chart under Train",
  },
];
