// The whole wasm package as it will be; to be deleted once it is.
import type { Claim, ComparisonSettings, Growth, PartSpec, Spread, TrainingSet } from "../../../crate/pkg/web/vcgpdm";

export * from "../../../crate/pkg/web/vcgpdm";
export { default } from "../../../crate/pkg/web/vcgpdm";

export type ModelKind = "vcgpdm" | "vgpdm" | "map-gpdm" | "map-cgpdm" | "tmp" | "dmp-discrete" | "dmp-rhythmic";
export type Candidate =
  | {
      model: "vcgpdm" | "vgpdm";
      latent: number;
      order: number;
      dynamicsIps: number;
      poseIps: number;
      maxIterations: number;
    }
  | { model: "map-gpdm" | "map-cgpdm"; latent: number; order: number; maxIterations: number; balanced: boolean }
  | { model: "tmp"; primitives: number | null }
  | { model: "dmp-discrete" | "dmp-rhythmic"; bases: number };
export interface Job {
  candidate: Candidate;
  heldOut: number;
  trainingTrials: number;
  seed: number;
}
export interface Score {
  dtwMse: number;
  mse: number;
  variance: number;
}
export interface Outcome {
  score: Score;
  bound: number | null;
  objective: number;
  iterations: number;
  seconds: number;
  frames: number;
  storedNumbers: number;
  reason: string | null;
}
export interface Trial {
  name: string;
  sha256: string;
  piece: [number, number] | null;
}
export interface Setting {
  trials: Trial[];
  parts: PartSpec[];
  framesPerSecond: number;
  startFrames: number;
}
export interface Plan {
  models: ModelKind[];
  latent: number;
  order: number;
  maxIterations: number;
  ips: number[];
  primitives: (number | null)[];
  bases: number[];
  balanced: boolean;
  heldOut: number[];
  seeds: number[];
  trainingTrials: number[];
  growth: boolean;
}
export interface PlannedJob {
  id: string;
  job: Job;
  done: boolean;
}
export interface FinishedJob {
  id: string;
  job: Job;
  engine: string;
  outcome: Outcome | null;
  failure: string | null;
}
export interface ModelSummary {
  model: ModelKind;
  candidate: Candidate;
  label: string;
  mse: Spread;
  mseMedian: number;
  variance: number;
  bound: Spread | null;
  seconds: Spread;
  storedNumbers: Spread;
  folds: number;
  runs: number;
}
export interface CorrelationPoint {
  label: string;
  bound: number;
  mse: number;
}
export interface Correlation {
  model: ModelKind;
  label: string;
  rank: number;
  settings: number;
  folds: number;
  points: CorrelationPoint[];
}
export interface Comparison {
  models: ModelSummary[];
  correlations: Correlation[];
  growth: Growth[];
  claims: Claim[];
}
export class Results {
  private constructor();
  free(): void;
  static empty(clips: TrainingSet, settings: ComparisonSettings): Results;
  static fromJson(text: string): Results;
  toJson(): string;
  setting(): Setting;
  finished(): FinishedJob[];
  jobs(plan: Plan): PlannedJob[];
  add(job: Job, outcome: Outcome): void;
  merge(other: Results): void;
  comparison(): Comparison;
}
export class Prediction {
  private constructor();
  free(): void;
  outcome(seconds: number): Outcome;
  positions(): Float32Array;
}
export class Fold {
  free(): void;
  constructor(clips: TrainingSet, settings: ComparisonSettings, heldOut: number, trainingTrials: number);
  actual(): Float32Array;
  readonly frameTime: number;
}
export class Evaluation {
  free(): void;
  constructor(fold: Fold, candidate: Candidate, seed: number);
  prediction(): Prediction;
  step(): { done: boolean; fraction: number };
}
