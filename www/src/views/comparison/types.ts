// What a comparison of models has found.

export type ModelId = "vcgpdm" | "vgpdm" | "map-gpdm" | "map-cgpdm" | "tmp" | "dmp-discrete" | "dmp-rhythmic";

/** A mean over runs. */
export interface Spread {
  mean: number;
  /** null: of one run nothing is known about others. */
  standardError: number | null;
  count: number;
}

/** A model with its settings. */
export interface ModelSummary {
  model: ModelId;
  /** Its settings in words: "8 + 8 inducing points". */
  label: string;
  /** Mean squared error after dynamic time warping, in the squared units of the columns. */
  mse: Spread;
  /** The same of a prediction that does not move. */
  variance: number;
  /** Nats; null: the model has none. */
  bound: Spread | null;
  /** Of a training. */
  seconds: Spread;
  /** Numbers that must be kept to roll out. */
  storedNumbers: Spread;
  folds: number;
  runs: number;
}

/** Bound and error of a model over its settings. */
export interface Correlation {
  model: ModelId;
  settings: number;
  /** Spearman's. */
  rank: number;
  points: { label: string; bound: number; mse: number }[];
}

/** How the time of an iteration grows with the frames trained on. */
export interface Growth {
  model: ModelId;
  points: { frames: number; seconds: number }[];
  exponent: number | null;
}

export interface Claim {
  claim: string;
  found: string;
  holds: boolean;
}

export interface Comparison {
  models: ModelSummary[];
  correlations: Correlation[];
  growth: Growth[];
  claims: Claim[];
}
