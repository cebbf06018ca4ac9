// The messages about libraries of primitives. Types only.
import type {
  CouplingsFrom,
  LibraryInfo,
  LibraryPlan,
  Misfit,
  ModularityFold,
  ModularityOutcome,
  PartMotion,
} from "vcgpdm";
import type { Couplings, Motion, Report, TrainingClip, TrainingOutcome, TrainingSettings } from "./protocol";

export type {
  CouplingsFrom,
  LibraryInfo,
  Misfit,
  ModularityFold,
  ModularityOutcome,
  PartMotion,
  PrimitiveOrigin,
} from "vcgpdm";

/** A change of an endless walk before its next frames. */
export type WalkChange =
  /** The part goes on with another of its primitives. */
  | { kind: "use"; part: number; primitive: number }
  /**
   * The predictions of the part become so much, 0 to 1, those of another of its primitives: little by little.
   */
  | { kind: "mix"; part: number; other: number; share: number }
  | { kind: "couplings"; alpha: Couplings }
  /** The couplings of a combination that nobody has fitted. */
  | { kind: "nearest"; uses: readonly number[] }
  /** 1: as learned. */
  | { kind: "tempo"; part: number; tempo: number };

/** Clips of several movements, those of one movement after the other. */
export interface LearningJob extends LibraryPlan {
  clips: TrainingClip[];
  settings: TrainingSettings;
}

/** Couplings that were fitted, and where they come from. */
export interface Fitted {
  alpha: Couplings;
  from: CouplingsFrom;
}

/** Couplings of a combination to be fitted to clips. */
export interface FittingJob {
  /** The document of the library. */
  library: string;
  uses: number[];
  clips: TrainingClip[];
  maxIterations: number;
}

/** Primitives of another library to be learned again under the pose maps of this one. */
export interface ImportJob {
  /** The document of the library that takes them in. */
  library: string;
  /** The document of theirs. */
  other: string;
  /** Clips of their movement; none: what their file keeps of it. */
  clips: TrainingClip[];
  maxIterations: number;
  seed: number;
}

/**
 * What came of it: the document of the library with them, and how much of each part's poses its pose maps do
 * not show.
 */
export interface Imported {
  text: string;
  lost: number[];
}

/**
 * A library with primitives of another file, and how many of them are new in it; or why they do not fit it.
 */
export type Addition = { text: string; info: LibraryInfo; added: number } | { misfit: Misfit };

/** One row of the map of tempo and coupling. */
export interface LockingJob {
  library: string;
  uses: number[];
  source: number;
  target: number;
  tempo: number;
  strengths: number[];
}

/**
 * What a worker does for libraries. It holds one library with one walk; what trains is told which library,
 * and keeps nothing.
 */
export interface LibraryWorker {
  /** Whether the document has a primitive of every part; else it can only be added to a library. */
  isWholeLibrary(text: string): boolean;
  /** Takes a library up in the place of the one before, which stays where that fails. */
  openLibrary(text: string): LibraryInfo;
  /** The couplings of a combination that nobody has fitted. */
  nearestCouplings(uses: number[]): Couplings;
  /** The first frames of a combination, under those couplings. */
  combinationMotion(uses: number[], frames: number): Motion;
  /** Which parts of a combination stand still in the long run, and to whom they listen. */
  combinationMoves(uses: number[], alpha: Couplings): PartMotion[];
  /** The document of a combination as a model. */
  combinationText(uses: number[], alpha: Couplings): string;
  /** Adds a combination to the library as a movement of that name; the walk goes on. */
  addCombination(
    name: string,
    uses: number[],
    alpha: Couplings,
    from: CouplingsFrom | null,
  ): { text: string; info: LibraryInfo };
  /** The document of these primitives as a library of their own. */
  primitivesText(primitives: number[]): string;
  /** Adds the primitives of another library; the walk goes on. Where they do not fit, nothing changes. */
  addPrimitives(text: string): Addition;
  importPrimitives(job: ImportJob, report: Report<Imported>, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Begins an endless walk in the place of the one before. */
  startWalk(uses: number[]): void;
  /**
   * Takes the last frames back, with what was changed since they were made, makes the changes, then computes
   * the next frames. Throws when there is no walk.
   */
  advanceWalk(back: number, changes: WalkChange[], frames: number): Motion;
  learnLibrary(job: LearningJob, report: Report<string>, signal: AbortSignal): Promise<TrainingOutcome>;
  fitCouplings(job: FittingJob, report: Report<Fitted>, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Trains without one trial. The last report brings the outcome, unless the training was cancelled. */
  holdOut(
    fold: ModularityFold,
    report: Report<ModularityOutcome>,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
  /** How well the target is locked to the source at each coupling, 0 to 1. */
  lockingRow(job: LockingJob): Float64Array;
}
