// The messages between the page and the workers of the whole program. Types only.
import type {
  AnswersFile,
  Candidate,
  Comparison,
  FinishedJob,
  Handles,
  Job,
  MadeMovement,
  ModelKind,
  Outcome,
  PartCompletion,
  PerceptionResults,
  Plan,
  PlanePicture,
  PlannedJob,
  LatentLogDensity,
  Setting,
  StudyInfo,
  StudyLook,
  StudyPreset,
  StudyTexts,
  StudyTrial,
  SyntheticFindings,
  SyntheticTruth,
  TrainingCost,
} from "vcgpdm";
import type { LibraryWorker } from "./library-protocol";
import type {
  ClipsWorker,
  Couplings,
  Figure,
  Health,
  JointInfo,
  Measures,
  Motion,
  PartSpec,
  Report,
  RolloutRequest,
  Trainee,
  TrainingClip,
  TrainingOutcome,
} from "./protocol";
import type { SeriesWorker } from "./series-protocol";

export type * from "vcgpdm";

/** The settings that all folds of a comparison share. */
export type ComparisonSettings = Pick<Setting, "parts" | "framesPerSecond">;

/** A job, with the clips and settings of its comparison. */
export interface EvaluationJob extends Job {
  /** The clips of all trials. */
  clips: TrainingClip[];
  settings: ComparisonSettings;
}

/** The outcome of one model in one fold. */
export interface Evaluated {
  outcome: Outcome;
  /** World positions of the prediction and of the held-out trial [frames x nodes x 3]. */
  predicted: Float32Array;
  actual: Float32Array;
  /** Seconds between frames. */
  frameTime: number;
  /** The document of the model. */
  model: string;
}

/** The results of a comparison for the page. */
export interface ResultsView {
  /** The file on disk. */
  text: string;
  setting: Setting;
  /** The finished jobs, in the order of the tables. */
  finished: FinishedJob[];
  comparison: Comparison;
}

/** The result of one job, added to results that the worker holds. */
export interface AddedResult {
  /** A number for the results with this one, which the worker holds until the next call. */
  state: number;
  /** The result as in a file, or the whole file if the result took the place of a failure. */
  text: string;
  isWhole: boolean;
  /** The result and its place in the order of the tables. */
  finished: FinishedJob;
  place: number;
  comparison: Comparison;
}

/** The trainings of a comparison, finished or not. */
export interface PlannedComparison {
  results: ResultsView;
  jobs: PlannedJob[];
  /** The estimated cost of each job. */
  costs: TrainingCost[];
  /** Whether the results include the known results. They do if the known results have the same setting. */
  goesOn: boolean;
}

/** One synthetic experiment. These values determine its data and its training. */
export interface Experiment {
  /** The seed of the data and of the training. */
  seed: number;
  /** Whether the first part drives the second. */
  driving: boolean;
  /** Inducing points of every function of the model: the paper's two numbers. */
  points: 4 | 10;
}

/** What a training on an experiment has found. */
export interface TrainedExperiment extends SyntheticFindings {
  /** The document of the model; empty before the end. */
  text: string;
}

/**
 * The calls of a worker for comparisons. The page has all results too, so the death of a worker loses none.
 */
export interface ComparisonWorker {
  /**
   * Trains the model of a job and evaluates it. Returns null if it was cancelled. `report` gets the finished
   * share of the training.
   */
  evaluate(
    job: EvaluationJob,
    report: (fraction: number) => void,
    signal: AbortSignal,
  ): Promise<Evaluated | null>;
  /**
   * The jobs of a plan on these clips. `known`: the text of earlier results, which are used if they have the
   * same setting.
   */
  planComparison(
    clips: TrainingClip[],
    settings: ComparisonSettings,
    plan: Plan,
    known: string | null,
  ): Promise<PlannedComparison>;
  /**
   * Adds the outcome of a job to results without an outcome of this job. `results`: the state of an earlier
   * answer, or the file. Null: the worker does not hold the results of this state.
   */
  addOutcome(results: number | string, job: Job, outcome: Outcome): AddedResult | null;
  /** Reads results. If the text is not a file of results, throws the reason. */
  openResults(text: string): ResultsView;
}

/** The calls of a worker for the synthetic experiment. */
export interface ExperimentWorker {
  /** The data of an experiment, and the true latents and couplings. */
  drawExperiment(experiment: Experiment): SyntheticTruth;
  /** Trains until the training ends or is cancelled. */
  trainExperiment(
    experiment: Experiment,
    report: Report<TrainedExperiment>,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
}

/** The latents of one part as a Gaussian in each frame of a rollout. */
export interface PartMoments {
  /** [frames x Q] */
  means: Float64Array;
  /** [frames x Q x Q] */
  covariances: Float64Array;
}

/** The inducing points that a model keeps, by index. */
export interface KeptPoints {
  /** [part] */
  poses: number[][];
  /** [source][target] */
  dynamics: number[][][];
}

/** The movement of a model with some of its inducing points only. */
export interface KeptReport {
  /** The bound, in nats. */
  bound: number;
  motion: Motion;
  /** Latent path of each part [frames x Q]. */
  latents: Float64Array[];
  measures: Measures;
  health: Health;
}

/** A recording of which one part is observed, under these couplings. */
export interface CompletionRequest extends Pick<RolloutRequest, "alpha" | "reading"> {
  clip: TrainingClip;
  /** The name of the observed part. */
  given: string;
  /** It is observed until this time, in seconds; null: to the end. */
  until: number | null;
}

/** A recording whose other parts a model has inferred. */
export interface CompletedClip {
  /** The observed part as recorded while it is observed, all else as inferred. */
  motion: Motion;
  recorded: Motion;
  /** The latents of the observed part [frames x Q]. */
  latents: Float64Array;
  /** The errors of the other parts. */
  scores: PartCompletion[];
}

/**
 * The calls of a worker for the uncertainty and the inducing points of a model, and for what it infers of a
 * recording. The worker keeps one model of a body open.
 */
export interface UncertaintyWorker {
  /** Opens the model of this document and closes the earlier model. */
  openOutlook(text: string): void;
  /** Moment matching over the frames of a rollout, for each part. */
  moments(request: RolloutRequest): PartMoments[];
  /** An image of the model's uncertainty in a plane through the latent space of a part. */
  paintPlane(request: RolloutRequest, part: number, picture: PlanePicture): ImageBitmap;
  /** The bound of the model with each of these choices of inducing points, in nats. */
  keptBounds(choices: KeptPoints[]): number[];
  /** Observes one part of a recording and infers the others. */
  complete(request: CompletionRequest): Promise<CompletedClip>;
  /**
   * The latents that the model of this document infers in the first frames of a clip, `[part][frame][dimension]`.
   * The frames count at the frame rate of the model.
   */
  inferStart(text: string, clip: TrainingClip, frames: number): Promise<number[][][]>;
  /** A motion of the open model as BVH; `columns`: all its columns [frames x columns]. */
  columnsBvh(columns: Float64Array, frames: number): string;
  /** How natural the motion of the model of this document is predicted to look. */
  latentLogDensity(text: string, request: RolloutRequest): LatentLogDensity;
  /** A rollout of the model with some of its inducing points only. */
  keptRollout(kept: KeptPoints, request: RolloutRequest): KeptReport;
}

/** A study for the page. */
export interface StudyView {
  /** The file on disk. */
  text: string;
  info: StudyInfo;
  /** The number of trials of a participant. */
  trials: number;
  plans: readonly StudyPlan[];
}

/** A plan that the study can have, with its times. `chosen`: the study has it. */
export interface StudyPlan extends Pick<StudyInfo, "crossSeconds" | "seconds" | "design"> {
  preset: StudyPreset;
  trials: number;
  chosen: boolean;
}

/** The changes that the page can make to a study. */
export interface StudyChange {
  preset?: StudyPreset;
  look?: StudyLook;
  texts?: StudyTexts;
  /** The ids of all movements that are marked as obvious failures. */
  failed?: string[];
}

/** A natural movement for a new study: a recorded trial. */
export interface NaturalMovement extends MadeMovement {
  /** World positions [frames x nodes x 3]. */
  positions: Float32Array;
}

/** A generated movement for a new study: a model's prediction of a trial. */
export interface GeneratedMovement extends NaturalMovement {
  candidate: Candidate;
  seed: number;
  outcome: Outcome;
}

/** The movements and settings of a new study from a comparison. */
export interface StudyRequest {
  title: string;
  /** A clip whose body moves in the study. */
  body: TrainingClip;
  framesPerSecond: number;
  natural: NaturalMovement[];
  generated: GeneratedMovement[];
}

/** The calls of a worker for the graphics Turing test. The worker keeps nothing between two calls. */
export interface PerceptionWorker {
  /** Reads a study. If the text is not a study, throws the reason. */
  openStudy(text: string): StudyView;
  changeStudy(text: string, change: StudyChange): StudyView;
  /** The trials of one participant, in order. */
  drawTrials(text: string, seed: number): StudyTrial[];
  /** World positions of each stimulus [frames x joints x 3]. */
  movements(text: string): Float32Array[];
  /** Analyses the answers to the study. */
  analysePerception(text: string, answers: AnswersFile[]): PerceptionResults;
  /** The analysis as the file that the terminal program writes. */
  perceptionJson(text: string, answers: AnswersFile[]): string;
  /** Makes a study and returns its text. */
  makeStudy(request: StudyRequest): Promise<string>;
}

/** A drag of a TMP's or DMP's figure. */
export interface Drag {
  frame: number;
  node: number;
  /** The wanted place of the node, in metres from the root. */
  place: [number, number, number];
  /** What it changes: the pose of the frame, or the goal. */
  changes: "pose" | "goal";
}

/** What is changed by hand: of a TMP or DMP its handles, of a MAP CGPDM its coupling variances. */
export type ByHand = Handles & { alpha?: Couplings };

/** A motion that a model of any kind has made. */
export interface MadeMotion {
  kind: ModelKind;
  figure: Figure;
  joints: JointInfo[];
  parts: PartSpec[];
  motion: Motion;
  /** The motion as BVH. */
  bvh: string;
  /** What was changed. */
  handles: ByHand;
  /** The learned coupling variances of a MAP CGPDM; empty for another kind, and where others were given. */
  alpha: Couplings;
}

export interface AnyModelWorker {
  /**
   * The rollout of a model of any kind, from the start of its first sequence; that of a TMP, DMP or MAP CGPDM as
   * changed by hand, with a drag that is added to the handles.
   */
  rollOutAny(text: string, frames: number, handles?: ByHand, drag?: Drag): MadeMotion;
}

/** All calls of a worker that runs the whole program. */
export interface WholeWorker
  extends Trainee,
    ClipsWorker,
    AnyModelWorker,
    ComparisonWorker,
    ExperimentWorker,
    UncertaintyWorker,
    LibraryWorker,
    PerceptionWorker,
    SeriesWorker {}
