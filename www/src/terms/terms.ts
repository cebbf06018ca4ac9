// The terms of the field. Their explanations are in the words of each language. `glossary`: the entry of
// docs/glossary.md for readers of the code, a name or a symbol.

export interface TermEntry {
  symbol?: string;
  glossary: string;
}

const ENTRIES = {
  alpha: { symbol: "α", glossary: "alpha^{ji}" },
  weight: { symbol: "w", glossary: "weight" },
  coupling: { symbol: "α, w", glossary: "coupling" },
  expert: { symbol: "f", glossary: "expert" },
  "product-of-experts": { glossary: "product of experts" },
  predictions: { glossary: "product of experts" },
  reading: { glossary: "reading" },
  measured: { glossary: "measures" },
  part: { symbol: "i, j", glossary: "part" },
  latent: { symbol: "x", glossary: "latent" },
  "latent-space": { symbol: "Q", glossary: "latent space" },
  "inducing-point": { symbol: "r, z", glossary: "inducing point" },
  "dynamics-points": { symbol: "K", glossary: "K" },
  "pose-points": { symbol: "L", glossary: "L" },
  "pose-map": { symbol: "g", glossary: "pose map" },
  lengthscale: { symbol: "√λ", glossary: "lambda" },
  "signal-variance": { symbol: "σ²", glossary: "sigma^2" },
  "noise-variance": { symbol: "β", glossary: "beta" },
  order: { symbol: "p", glossary: "order" },
  bound: { symbol: "ELBO", glossary: "ELBO" },
  "bound-terms": { glossary: "bound, terms" },
  nats: { glossary: "nat" },
  iterations: { glossary: "iteration" },
  seed: { glossary: "seed" },
  "movement-primitive": { glossary: "movement primitive" },
  rollout: { glossary: "rollout" },
  future: { glossary: "future" },
  "moment-matching": { glossary: "moment matching" },
  map: { glossary: "MAP" },
  tmp: { symbol: "TMP", glossary: "TMP" },
  dmp: { symbol: "DMP", glossary: "DMP" },
  bases: { glossary: "bases" },
  dtw: { glossary: "DTW MSE" },
  fold: { glossary: "fold" },
  "confusion-rate": { glossary: "confusion rate" },
  "attention-check": { glossary: "attention check" },
  "catch-trial": { glossary: "catch trial" },
  "ln-k": { glossary: "ln K" },
} satisfies Record<string, TermEntry>;

export type TermName = keyof typeof ENTRIES;

export const TERMS: Readonly<Record<TermName, TermEntry>> = ENTRIES;
