// The messages about libraries of primitives. Types only.
import type { CouplingsFrom, LibraryInfo, LibraryPlan, PartMotion, RecognisedSegment } from "vcgpdm";
import type {
  Couplings,
  LiveFrames,
  LiveStep,
  Motion,
  Report,
  TrainingClip,
  TrainingOutcome,
  TrainingSettings,
} from "./protocol";

export type {
  CouplingsFrom,
  LibraryInfo,
  PartMotion,
  PrimitiveOrigin,
  RecognisedSegment,
} from "vcgpdm";

/** A training of a library. The clips are in the order of the movements. */
export interface LearningJob extends Pick<LibraryPlan, "movements"> {
  /** For each part, whether all movements share its primitive. */
  shared: boolean[];
  clips: TrainingClip[];
  settings: TrainingSettings;
}

/** Fitted couplings and their origin. */
export interface Fitted {
  alpha: Couplings;
  from: CouplingsFrom;
}

/** A fit of the couplings of a combination to clips. */
export interface FittingJob {
  /** The document of the library. */
  library: string;
  uses: number[];
  clips: TrainingClip[];
  maxIterations: number;
}

/** Clips, one after the other, whose primitives are wanted. */
export interface RecognitionJob {
  /** The document of the library. */
  library: string;
  clips: TrainingClip[];
}

/** A recording, and the primitives that its parts use at which time. */
export interface Recognised {
  motion: Motion;
  segments: RecognisedSegment[];
}

/** A movement that a library learned as a whole. */
export interface RecordedMovement {
  name: string;
  /** The document of its model. */
  model: string;
  /** Clips that the model makes, as BVH: one for each clip that it learned from, started as that clip starts. */
  clips: string[];
}

/**
 * The calls of a worker for libraries. The worker keeps one library with one walk. The trainings get the
 * library as an argument and keep nothing.
 */
export interface LibraryWorker {
  /** Whether the library has a primitive for each part. If not, it can only be added to another library. */
  isWholeLibrary(text: string): boolean;
  /** The learned movements of a library, which is not opened. */
  recordedMovements(text: string): RecordedMovement[];
  /** Opens a library and closes the earlier one. If opening fails, the earlier library stays open. */
  openLibrary(text: string): LibraryInfo;
  /** The nearest couplings, for a combination without fitted couplings. */
  nearestCouplings(uses: number[]): Couplings;
  /** The first frames of a combination under its nearest couplings. */
  combinationMotion(uses: number[], frames: number): Motion;
  /**
   * The long-run motion of each part of a combination: whether the part stands still, and which other part
   * drives it.
   */
  combinationMoves(uses: number[], alpha: Couplings): PartMotion[];
  /** A combination as the document of a model. */
  combinationText(uses: number[], alpha: Couplings): string;
  /** Adds a combination to the library as a movement of that name. The walk continues. */
  addCombination(
    name: string,
    uses: number[],
    alpha: Couplings,
    from: CouplingsFrom | null,
  ): { text: string; info: LibraryInfo };
  /** The document of a library with only these primitives. */
  primitivesText(primitives: number[]): string;
  /**
   * Adds the primitives of another library. The walk continues. If the primitives do not fit, throws the
   * reason, and nothing changes.
   */
  addPrimitives(text: string): { text: string; info: LibraryInfo };
  /** Starts an endless walk. An earlier walk ends. */
  startWalk(uses: number[]): void;
  /** Throws if there is no walk. */
  advanceWalk(step: LiveStep): LiveFrames;
  learnLibrary(job: LearningJob, report: Report<string>, signal: AbortSignal): Promise<TrainingOutcome>;
  fitCouplings(job: FittingJob, report: Report<Fitted>, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Reports the share that is done. Answers null if it was cancelled. */
  recognise(
    job: RecognitionJob,
    report: (fraction: number) => void,
    signal: AbortSignal,
  ): Promise<Recognised | null>;
}
