// The messages between the page and its workers. Types only.
import type {
  ClipInfo,
  DocumentKind,
  Health,
  Measures,
  CoupledModelInfo as ModelInfo,
  SampleInfo,
  TrainingCost,
  TrainingProgress,
  TrainingSettings,
  VariationalSettings,
} from "vcgpdm";
import type { Calls } from "./calls";

export type {
  ClipInfo,
  DocumentKind,
  Figure,
  FigureNode,
  Health,
  JointInfo,
  Measures,
  CoupledModelInfo as ModelInfo,
  PartSpec,
  PartsPreset,
  Provenance,
  SampleInfo,
  Setbacks,
  TrainingCost,
  TrainingProgress,
  TrainingSettings,
} from "vcgpdm";

/** The effect of changed couplings on the experts. */
export type Reading = "as-learned" | "re-inferred";

/** A square table indexed [source][target]. */
export type Couplings = number[][];

/** World positions of a figure's nodes over time, y up, metres. */
export interface Motion {
  /** [frames x nodes x 3] */
  positions: Float32Array;
  frames: number;
  nodes: number;
  /** Seconds between frames. */
  frameTime: number;
}

/** A clip that is open in the worker, with its motion. */
export interface LoadedClip {
  /** The worker's number for the clip. */
  id: number;
  info: ClipInfo;
  motion: Motion;
}

/** The dynamics inducing points of one coupling. */
export interface DynamicsInducing {
  count: number;
  /** Histories, oldest state first [count x order*Qsource]. */
  inputs: Float64Array;
  /** Predictions [count x Qtarget]. */
  outputs: Float64Array;
}

/** A fitted model as the page sees it: everything but its functions. */
export interface ModelView {
  /** Grows with every model that the worker opens; results of an older model are dropped. */
  revision: number;
  /** SHA-256 of its document, as it is saved; hexadecimal. */
  sha256: string;
  info: ModelInfo;
  /** Pose inducing inputs of each part [L x Q]. */
  poseInducing: Float64Array[];
  /** [source][target] */
  dynamicsInducing: DynamicsInducing[][];
  /**
   * Latent means of the training frames of each part [N x Q]; null for a model from a file. The page adds
   * them.
   */
  trainingLatents: Float64Array[] | null;
}

export interface RolloutRequest {
  frames: number;
  sequence: number;
  /** The frame of the sequence that begins it; absent: the first. */
  frame?: number;
  /** Absent: as learned. */
  alpha: Couplings | null;
  reading: Reading;
}

export interface RolloutResult {
  revision: number;
  request: RolloutRequest;
  motion: Motion;
  /** Latent path of each part [frames x Q]. */
  latents: Float64Array[];
  /** w[source][target] */
  weights: Couplings;
}

/** The motion of the body in a rollout, and how it ends. */
export interface BodyReport {
  revision: number;
  request: RolloutRequest;
  measures: Measures;
  health: Health;
}

/** Gaussian predictions of the latents of one part, one for each frame. */
export interface Predictions {
  /** [predicted frames x Q] */
  means: Float64Array;
  /** The same in all dimensions [predicted frames]. */
  variances: Float64Array;
}

/** The predictions for each part in each frame of a rollout. */
export interface PredictionsReport {
  revision: number;
  request: RolloutRequest;
  /** The first frame that is predicted. */
  firstFrame: number;
  /** For each part the prediction of each source, and their product. */
  parts: { experts: Predictions[]; product: Predictions }[];
}

/** The next frames of a live rollout. */
export interface LiveFrames {
  motion: Motion;
  /** Latent path of each part [frames x Q]. */
  latents: Float64Array[];
  /** The phase of each part on the learned cycle, in turns [frames x parts]; empty without a cycle. */
  phases: Float64Array;
  /** How far from the learned cycle each part is, in radii of its cycle [frames x parts]; empty as phases. */
  distances: Float64Array;
}

/** A change of a live rollout before its next frames. */
export type LiveChange =
  | { kind: "couplings"; alpha: Couplings; reading: Reading }
  | { kind: "cut"; source: number; target: number; cut: boolean }
  /** Moves a part in its latent space. */
  | { kind: "push"; part: number; by: number[] }
  /** Moves a node of the figure, in metres. */
  | { kind: "pull"; node: number; by: [number, number, number] };

/** A model with its rollout as learned. */
export interface OpenedModel {
  model: ModelView;
  rollout: RolloutResult;
}

/** The source of a clip: every worker that trains on it reads it itself. */
export type ClipSource = { sample: string } | { name: string; file: Blob };

/** A clip chosen for training: frames first (counted from 0) up to, not including, end. */
export interface TrainingClip {
  id: number;
  source: ClipSource;
  first: number;
  end: number;
  /** Whether it takes the bones of the first of the clips, where its own differ. */
  firstBones?: boolean;
}

/** Why clips cannot be trained on together. */
export interface Clash {
  words: string;
  /** Whether only their bones differ. Then all clips can have those of the first. */
  bones: boolean;
}

/** The inducing point that the visitor points at. */
export type InducingPoint =
  | { kind: "pose"; part: number; index: number }
  | { kind: "dynamics"; source: number; target: number; index: number };

/** The meaning of an inducing point. */
export interface InducingReport {
  point: InducingPoint;
  /** Node positions of the pose, and for a dynamics point of the pose it predicts [nodes x 3]. */
  poses: Float32Array[];
  /** The weight of the point in each frame of the rollout, 0..1 [frames]. */
  frames: Float64Array;
}

/** A trained model on its way from the worker that trained it to the one that shows it. */
export interface TrainedModel {
  /** The shared JSON document. */
  text: string;
  /** Latent means of the training frames of each part [N x Q]. */
  latents: Float64Array[];
  /** How its rollout ends; null where it has none. */
  health: Health | null;
}

/** Sent about ten times a second while something is trained, and when the training ends. */
export interface TrainingReport<Found> {
  /** One entry for each iteration since the last report. */
  steps: TrainingProgress[];
  /** The newest iteration. */
  progress: TrainingProgress;
  /** Seconds since it began, or since it went on. */
  elapsed: number;
  /** The best so far: with the last report, and where the answer to an earlier one asked for it. */
  found: Found | null;
  /** With the first report: what the visitor should know of the data and the settings. */
  notices?: string[];
}

/** May answer that the next report is to bring the best so far. */
export type Report<Found> = (report: TrainingReport<Found>) => unknown;

export interface TrainingOutcome {
  /** A cancelled training keeps the best so far. */
  cancelled: boolean;
  /** Why training ended; null when it was cancelled. */
  reason: TrainingProgress["reason"];
  /** What the visitor should know of the data and the settings: sentences without a full stop. */
  notices?: string[];
}

export interface CostQuestion {
  settings: VariationalSettings;
  frames: number;
  /** Columns of each part. */
  columns: number[];
}

export interface TrainingJob {
  clips: TrainingClip[];
  settings: TrainingSettings;
  /** The length of the rollout by which the model is judged. */
  frames: number;
}

/**
 * A worker that trains, one model at a time. Here and in the other workers, a signal ends a training early: the
 * best so far is kept.
 */
export interface Trainee {
  start(wasm: WebAssembly.Module): Promise<unknown>;
  /** The worker keeps what it trained until the next training. */
  train(job: TrainingJob, report: Report<TrainedModel>, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Continues the training that the worker keeps, for at most this many more iterations. */
  goOn(iterations: number, report: Report<TrainedModel>, signal: AbortSignal): Promise<TrainingOutcome>;
}

/** The worker that shows clips and models. */
export interface Workbench {
  start(wasm: WebAssembly.Module): Promise<{ version: string; samples: SampleInfo[] }>;
  freshSeed(): number;
  documentKind(text: string): DocumentKind;
  readClip(name: string, bytes: Uint8Array): LoadedClip;
  sampleClip(id: string): LoadedClip;
  dropClip(id: number): void;
  /**
   * Why these clips cannot be trained on together, all with the bones of the first where that is asked for;
   * null: they can.
   */
  checkTogether(ids: number[], firstBones: boolean): Clash | null;
  /**
   * Which of several models of the same data is to be shown, from the ranks of their rollouts' health and
   * their bounds.
   */
  bestToShow(ranks: number[], bounds: number[]): number;
  /** The cost of a training here. */
  trainingCost(question: CostQuestion): TrainingCost;
  /** The model and its rollouts carry the number `revision`. */
  openModel(text: string, frames: number, revision: number): OpenedModel;
  rollout(request: RolloutRequest): RolloutResult;
  inducing(point: InducingPoint, rollout: RolloutRequest): InducingReport;
  modelJson(): string;
  rolloutBvh(request: RolloutRequest): string;
  /** The motion of the body from frame `first` on. */
  bodyReport(request: RolloutRequest, first: number): BodyReport;
  predictions(request: RolloutRequest): PredictionsReport;
  /** Sampled rollouts: of the seeds `seed`, `seed + 1`, and so on. */
  futures(request: RolloutRequest, count: number, seed: number): RolloutResult[];
  /** Begins a live rollout after a frame of a rollout of the open model. An earlier live rollout ends. */
  startLive(request: RolloutRequest, frame: number): void;
  /** Makes the changes, then computes the next frames. Throws when there is no live rollout. */
  advanceLive(changes: LiveChange[], frames: number): LiveFrames;
  endLive(): void;
  /** The frames of a clip from first (counted from 0) up to, not including, end. */
  clipBvh(id: number, first: number, end: number): string;
}

/** The calls of the page to the worker that shows, whichever worker that is now. */
export type Engine = Calls<Omit<Workbench, "start" | "openModel">> & {
  openModel(text: string, frames: number): Promise<OpenedModel>;
};
