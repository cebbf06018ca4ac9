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
  UpAxis,
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
  UpAxis,
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

/** What the page shows of a clip. */
export interface ShownClip {
  info: ClipInfo;
  motion: Motion;
  /** The frames a second that were assumed, and why: the file's own frame time is no time. */
  assumed?: { fps: number; why: string };
}

/** An open clip of the page. */
export interface LoadedClip extends ShownClip {
  /** The page's number for the clip. */
  id: number;
}

/** The dynamics inducing points of one coupling. */
export interface DynamicsInducing {
  count: number;
  /** Histories, oldest state first [count x order*Qsource]. */
  inputs: Float64Array;
  /** Predictions [count x Qtarget]. */
  outputs: Float64Array;
}

/** A fitted model for the page, without its functions. */
export interface ModelView {
  /** Increases with each model that the worker opens. The page ignores results of an earlier model. */
  revision: number;
  /** SHA-256 of the saved document, hexadecimal. */
  sha256: string;
  info: ModelInfo;
  /** Pose inducing inputs of each part [L x Q]. */
  poseInducing: Float64Array[];
  /** [source][target] */
  dynamicsInducing: DynamicsInducing[][];
  /**
   * Latent means of the training frames of each part [N x Q]. The page sets them; null for a model from a
   * file.
   */
  trainingLatents: Float64Array[] | null;
}

export interface RolloutRequest {
  frames: number;
  sequence: number;
  /** The frame of the sequence at which the rollout starts; absent: the first. */
  frame?: number;
  /**
   * Latents that begin the rollout in place of the sequence, `[part][frame][dimension]`; `sequence` is then 0.
   */
  start?: number[][][];
  /** Absent: the learned couplings. */
  alpha: Couplings | null;
  reading: Reading;
  /** The seed of a sampled rollout; absent: the mean rollout. */
  sample?: number;
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

/** The motion of the body in a rollout, and the health of the rollout. */
export interface BodyReport {
  revision: number;
  request: RolloutRequest;
  measures: Measures;
  health: Health;
}

/** Gaussian predictions of the latents of one part in each frame. */
export interface Predictions {
  /** [predicted frames x Q] */
  means: Float64Array;
  /** One variance for all dimensions [predicted frames]. */
  variances: Float64Array;
}

/** The predictions for each part in each frame of a rollout. */
export interface PredictionsReport {
  revision: number;
  request: RolloutRequest;
  /** The first predicted frame. */
  firstFrame: number;
  /** For each part, the prediction of each source and the product of the predictions. */
  parts: { experts: Predictions[]; product: Predictions }[];
}

/** The next frames of a live motion. */
export interface LiveFrames {
  motion: Motion;
  /** Latent path of each part [frames x Q]. */
  latents: Float64Array[];
  /** All columns of the motion [frames x columns]. */
  columns: Float64Array;
  /** The phase of each part on the learned cycle, in turns [frames x parts]. Empty if there is no cycle. */
  phases: Float64Array;
  /**
   * The distance of each part from its learned cycle, in radii of the cycle [frames x parts]. Empty if
   * `phases` is empty.
   */
  distances: Float64Array;
  /** The frame of the recording that moves each part [frames x parts], -1 without a recording. */
  recorded: Int32Array;
}

/** The body of a live motion. */
export type LiveBody = Pick<ModelInfo, "figure" | "frameTime" | "joints" | "parts">;

/** A change of a live motion before its next frames. */
export type LiveChange =
  | { kind: "couplings"; alpha: Couplings; reading: Reading }
  /** Sets the couplings to the nearest couplings of a combination of primitives. */
  | { kind: "nearest"; uses: readonly number[] }
  /** Switches the part to another of its primitives. */
  | { kind: "use"; part: number; primitive: number }
  /** 1 is the learned tempo. */
  | { kind: "tempo"; part: number; tempo: number }
  | { kind: "cut"; source: number; target: number; cut: boolean }
  /** Moves a part in its latent space. */
  | { kind: "push"; part: number; by: number[] }
  /** Moves a node of the figure, in metres. */
  | { kind: "pull"; node: number; by: [number, number, number] }
  /** Drives a part round its learned cycle, by turns within the next frames, until it is released. */
  | { kind: "drive"; part: number; turns: number }
  /** Lets a recording with these latents [frames x Q] move a part until it is released. */
  | { kind: "record"; part: number; latents: Float64Array }
  /** Lets the part of a node follow a place, in metres relative to the root, until it is released. */
  | { kind: "reach"; node: number; place: [number, number, number] }
  | { kind: "release"; part: number };

/** What a live motion is asked for. */
export interface LiveStep {
  /** Takes the last frames back, with all changes made since. */
  back: number;
  changes: LiveChange[];
  /** How many frames to compute after the changes. */
  frames: number;
}

/** A model with its rollout under the learned couplings. */
export interface OpenedModel {
  model: ModelView;
  rollout: RolloutResult;
}

/**
 * The source of a clip. Each worker that trains on the clip reads the source. `up`, `fps` and `root`: the axis, the
 * frames a second and, of several bodies, the root joint that the visitor states. `note`: how a clip was made here.
 */
export type ClipSource =
  | { sample: string }
  | { name: string; file: Blob; up?: UpAxis; fps?: number; root?: string; note?: string };

/** A clip chosen for training: the frames from `first` (counted from 0) up to but not including `end`. */
export interface TrainingClip {
  id: number;
  source: ClipSource;
  first: number;
  end: number;
  /** Whether the clip gets the bones of the first clip if its own differ. */
  firstBones?: boolean;
}

/** The reason why clips cannot be trained on together. */
export interface Clash {
  words: string;
  /** Whether only the bones differ. Then all clips can use the bones of the first clip. */
  bones: boolean;
}

/** The inducing point under the visitor's pointer. */
export type InducingPoint =
  | { kind: "pose"; part: number; index: number }
  | { kind: "dynamics"; source: number; target: number; index: number };

/** The poses and weights of an inducing point. */
export interface InducingReport {
  point: InducingPoint;
  /** Node positions of the pose [nodes x 3]. A dynamics point also has the pose that it predicts. */
  poses: Float32Array[];
  /** The weight of the point in each frame of the rollout, 0..1 [frames]. */
  frames: Float64Array;
}

/** A trained model, which the page passes from the training worker to the workbench. */
export interface TrainedModel {
  /** The shared JSON document. */
  text: string;
  /** Latent means of the training frames of each part [N x Q]. */
  latents: Float64Array[];
  /** The health of the model's rollout; null if unknown. */
  health: Health | null;
  /** The error of the model's rollouts on the clips; null if unknown, as before the end of the training. */
  error: number | null;
}

/** A report of a training. The worker sends it about ten times a second, and when the training ends. */
export interface TrainingReport<Found> {
  /** One entry for each iteration since the last report. */
  steps: TrainingProgress[];
  /** The newest iteration. */
  progress: TrainingProgress;
  /** Seconds since the training began or was continued. */
  elapsed: number;
  /**
   * The best result so far. It comes with the last report, and when the page asked for it; otherwise null.
   */
  found: Found | null;
  /** Notices for the visitor about the data and the settings. They come with the first report. */
  notices?: string[];
}

/** Handles a report. Returns true to get the best result with the next report. */
export type Report<Found> = (report: TrainingReport<Found>) => unknown;

export interface TrainingOutcome {
  /** Whether the training was cancelled. The best result so far is kept. */
  cancelled: boolean;
  /** The reason why training ended; null if it was cancelled. */
  reason: TrainingProgress["reason"];
  /** Notices for the visitor about the data and the settings: sentences without a full stop. */
  notices?: string[];
}

export interface CostQuestion {
  /** Numbers of inducing points of 0 stand for those that the library gives these clips. */
  settings: VariationalSettings;
  frames: number;
  /** Seconds of the longest clip. */
  longest: number;
  /** The number of columns of each part. */
  columns: number[];
}

/** The cost of a training, and the settings that the library gives these clips. */
export interface PlannedTraining extends TrainingCost {
  usual: VariationalSettings;
  /** As in the question. */
  longest: number;
}

export interface TrainingJob {
  clips: TrainingClip[];
  settings: TrainingSettings;
  /** How many iterations the training is allowed on top of those of its settings. */
  more: number;
  /** The length of the rollout that determines the health of the model. */
  frames: number;
}

/**
 * The calls of a training worker, which trains one model at a time. In all workers, a signal ends a training
 * early and the best result so far is kept.
 */
export interface Trainee {
  start(wasm: WebAssembly.Module): Promise<unknown>;
  /** Trains a model. The worker keeps the training until the next one. */
  train(job: TrainingJob, report: Report<TrainedModel>, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Continues the last training for at most this many more iterations. */
  goOn(iterations: number, report: Report<TrainedModel>, signal: AbortSignal): Promise<TrainingOutcome>;
}

/** The calls of the workbench, the worker that shows models. */
export interface Workbench {
  start(wasm: WebAssembly.Module): Promise<{ version: string; samples: SampleInfo[] }>;
  freshSeed(): number;
  documentKind(text: string): DocumentKind;
  /** A clip that the project makes itself. */
  sampleClip(id: string): ShownClip;
  /**
   * The index of the model to show, among several models of the same data. The choice uses the ranks of their
   * rollouts' health, and the errors of their rollouts on the clips.
   */
  bestToShow(ranks: number[], errors: number[]): number;
  /** The estimated cost of a training in the browser, and the usual settings. */
  trainingCost(question: CostQuestion): PlannedTraining;
  /** Opens a model. The model and its rollouts get the number `revision`. */
  openModel(text: string, frames: number, revision: number): OpenedModel;
  rollout(request: RolloutRequest): RolloutResult;
  inducing(point: InducingPoint, rollout: RolloutRequest): InducingReport;
  /**
   * World positions of the figure's nodes [nodes x 3] with every part at a latent point. `latents`: the points
   * of all parts, one after the other.
   */
  bodyPose(latents: Float64Array): Float32Array;
  /** The share of the prior variance of a part's pose map that is left at latent points [points x Q]. */
  poseVariance(part: number, latents: Float64Array): Float64Array;
  modelJson(): string;
  rolloutBvh(request: RolloutRequest): string;
  /** The motion of the body from frame `first` on. */
  bodyReport(request: RolloutRequest, first: number): BodyReport;
  predictions(request: RolloutRequest): PredictionsReport;
  /** Sampled rollouts with the seeds `seed`, `seed + 1`, and so on. */
  futures(request: RolloutRequest, count: number, seed: number): RolloutResult[];
  /** Starts a live rollout after a frame of a rollout of the open model. An earlier live rollout ends. */
  startLive(request: RolloutRequest, frame: number): void;
  /** Throws if there is no live rollout. */
  advanceLive(step: LiveStep): LiveFrames;
  endLive(): void;
}

/**
 * The calls of a worker of the whole program that reads clips. The worker that shows reads no files, so that
 * the first visit is small.
 */
export interface ClipsWorker {
  /** All clips that the project makes itself, also those that a first visit does not bring. */
  madeClips(): SampleInfo[];
  /** Reads a clip of the visitor. */
  readClip(source: ClipSource): Promise<ShownClip>;
  /** The reason why these clips cannot be trained on together; null if they can. */
  checkTogether(clips: TrainingClip[]): Promise<Clash | null>;
  /** The chosen frames of a clip as BVH. */
  clipBvh(clip: TrainingClip): Promise<string>;
}

export type ClipCalls = Calls<ClipsWorker>;

/** The calls of the page to the workbench. They reach the current worker, also after a replacement. */
export type Engine = Calls<Omit<Workbench, "start" | "openModel">> & {
  openModel(text: string, frames: number): Promise<OpenedModel>;
};
