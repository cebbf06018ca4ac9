// The messages between the page and the workers of the whole program. Types only.
import type {
  AnswersFile,
  Candidate,
  Comparison,
  ComparisonSettings,
  FinishedJob,
  Job,
  MadeMovement,
  Outcome,
  PerceptionResults,
  Plan,
  PlanePicture,
  PlannedJob,
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
import type { Report, RolloutRequest, Trainee, TrainingClip, TrainingOutcome } from "./protocol";
import type { SeriesWorker } from "./series-protocol";

export type {
  AnswersFile,
  Candidate,
  Claim,
  Comparison,
  ComparisonSettings,
  Confusion,
  Correlation,
  FinishedJob,
  Growth,
  Job,
  ModelKind,
  ModelSummary,
  Outcome,
  Participant,
  PerceptionResults,
  Plan,
  PlanePicture,
  PlannedJob,
  Regression,
  Setting,
  SettingResult,
  Spread,
  StudyInfo,
  StudyPreset,
  StudyStimulus,
  StudyTexts,
  StudyTrial,
  SyntheticFindings,
  SyntheticTruth,
} from "vcgpdm";

/** A job, and what it is carried out on. */
export interface EvaluationJob extends Job {
  /** All trials. */
  clips: TrainingClip[];
  settings: ComparisonSettings;
}

/** The outcome of one model in one fold. */
export interface Evaluated {
  outcome: Outcome;
  /** World positions of the prediction and of the trial held out [frames x nodes x 3]. */
  predicted: Float32Array;
  actual: Float32Array;
  /** Seconds between frames. */
  frameTime: number;
}

/** The results of a comparison as the page sees them. */
export interface ResultsView {
  /** The file on disk. */
  text: string;
  setting: Setting;
  /** In the order of tables. */
  finished: FinishedJob[];
  comparison: Comparison;
}

/** The trainings of a comparison, and which of them are done. */
export interface PlannedComparison {
  results: ResultsView;
  jobs: PlannedJob[];
  /** What each of the jobs will cost. */
  costs: TrainingCost[];
  /** Whether the results include the known results, which are then of the same setting. */
  goesOn: boolean;
}

/** One synthetic experiment: its data and its training follow from these. */
export interface Experiment {
  /** The seed of the data and of the training. */
  seed: number;
  /** Whether the first part drives the second. */
  driving: boolean;
}

/**
 * What a worker does for comparisons. It keeps nothing between two calls, so that one that dies loses
 * nothing.
 */
export interface ComparisonWorker {
  /** Answers null when it was cancelled. `report` gets the share of the training that is done. */
  evaluate(
    job: EvaluationJob,
    report: (fraction: number) => void,
    signal: AbortSignal,
  ): Promise<Evaluated | null>;
  /**
   * The jobs of a plan on these clips. `known`: the text of results that are gone on with if they are of the
   * same setting.
   */
  planComparison(
    clips: TrainingClip[],
    settings: ComparisonSettings,
    plan: Plan,
    known: string | null,
  ): Promise<PlannedComparison>;
  /** Adds what came of a job to the results of which this is the text. */
  addOutcome(text: string, job: Job, outcome: Outcome): ResultsView;
  /** Throws with the reason when the text holds no results. */
  openResults(text: string): ResultsView;
}

/** The synthetic experiment. */
export interface ExperimentWorker {
  /** The data of an experiment, and the truth about them. */
  drawExperiment(experiment: Experiment): SyntheticTruth;
  /** Trains until it is done or cancelled. */
  trainExperiment(
    experiment: Experiment,
    report: Report<SyntheticFindings>,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
}

/** The latents of one part in each frame of a rollout as Gaussians. */
export interface PartMoments {
  /** [frames x Q] */
  means: Float64Array;
  /** [frames x Q x Q] */
  covariances: Float64Array;
}

/** How sure a model is. The worker keeps one model of a body open. */
export interface UncertaintyWorker {
  /** Keeps the model of this document open in the place of the one before. */
  openOutlook(text: string): void;
  /** Moment matching through time, for each part. */
  moments(request: RolloutRequest): PartMoments[];
  /** A picture of how sure the model is in a plane through the latent space of a part. */
  paintPlane(request: RolloutRequest, part: number, picture: PlanePicture): ImageBitmap;
}

/** A study as the page sees it. */
export interface StudyView {
  /** The file on disk. */
  text: string;
  info: StudyInfo;
  /** How many trials a participant has. */
  trials: number;
}

/** What the page changes of a study. */
export interface StudyChange {
  preset?: StudyPreset;
  look?: StudyLook;
  texts?: StudyTexts;
  /** The movements that are marked as obvious failures, by their ids: these and no others. */
  failed?: string[];
}

/** A natural movement of a study that is to be made: a trial as it was. */
export interface NaturalMovement extends MadeMovement {
  /** World positions [frames x nodes x 3]. */
  positions: Float32Array;
}

/** What a model made of a trial. */
export interface GeneratedMovement extends NaturalMovement {
  candidate: Candidate;
  seed: number;
  outcome: Outcome;
}

/** A study that is to be made from a comparison. */
export interface StudyRequest {
  title: string;
  /** A clip of the body that moves. */
  body: TrainingClip;
  framesPerSecond: number;
  natural: NaturalMovement[];
  generated: GeneratedMovement[];
}

/** What a worker does for the graphics Turing test. It keeps nothing between two calls. */
export interface PerceptionWorker {
  /** Throws with the reason when the text holds no study. */
  openStudy(text: string): StudyView;
  changeStudy(text: string, change: StudyChange): StudyView;
  /** The trials of one participant, in their order. */
  drawTrials(text: string, seed: number): StudyTrial[];
  /** World positions of each stimulus [frames x joints x 3]. */
  movements(text: string): Float32Array[];
  /** What these answers say of the study. */
  analysePerception(text: string, answers: AnswersFile[]): PerceptionResults;
  /** The same as the file that the terminal writes. */
  perceptionJson(text: string, answers: AnswersFile[]): string;
  /** Answers the text of the study. */
  makeStudy(request: StudyRequest): Promise<string>;
}

/** A worker of the whole program. */
export interface WholeWorker
  extends Trainee,
    ComparisonWorker,
    ExperimentWorker,
    UncertaintyWorker,
    LibraryWorker,
    PerceptionWorker,
    SeriesWorker {}
