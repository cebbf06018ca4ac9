// What the page and the workers of the whole program say to each other about libraries of primitives. Types only.
import type { LibraryInfo, LibraryPlan } from "vcgpdm";
import type { Couplings, Motion, TrainingClip, TrainingOutcome, TrainingProgress, TrainingSettings } from "./protocol";

export type { LibraryInfo } from "vcgpdm";

/** What may happen to an endless walk before its next frames. */
export type WalkChange =
  /** The part goes on with another of its primitives. */
  | { kind: "use"; part: number; primitive: number }
  /** The predictions of the part are so much, 0 to 1, those of another of its primitives. */
  | { kind: "mix"; part: number; other: number; share: number }
  | { kind: "couplings"; alpha: Couplings }
  /** 1: as learned. */
  | { kind: "tempo"; part: number; tempo: number };

/** Clips of several movements, those of one movement after the other. */
export interface LearningJob extends LibraryPlan {
  clips: TrainingClip[];
  settings: TrainingSettings;
}

/** Sent about ten times a second while a library is learned or couplings are fitted, and when it ends. */
export interface LibraryReport<Found> {
  progress: TrainingProgress;
  /** Seconds since the start. */
  elapsed: number;
  /** The best so far: with the last report. */
  found: Found | null;
}

/** Couplings of a combination to be fitted to clips. */
export interface FittingJob {
  /** The document of the library. */
  library: string;
  uses: number[];
  clips: TrainingClip[];
  maxIterations: number;
}

/** One row of the map of tempo and coupling. */
export interface LockingJob {
  library: string;
  uses: number[];
  source: number;
  target: number;
  tempo: number;
  strengths: number[];
}

/** What a worker does for libraries. It holds one library with one walk; what trains is told which library, and keeps nothing. */
export interface LibraryWorker {
  /** Takes a library up in the place of the one before, which stays where that fails. */
  openLibrary(text: string): LibraryInfo;
  /** The couplings of a combination that nobody has fitted. */
  nearestCouplings(uses: number[]): Couplings;
  /** The first frames of a combination, under those couplings. */
  combinationMotion(uses: number[], frames: number): Motion;
  /** The document of a combination as a model. */
  combinationText(uses: number[], alpha: Couplings): string;
  /** Adds a combination to the library as a movement of that name; the walk goes on. */
  addCombination(name: string, uses: number[], alpha: Couplings): { text: string; info: LibraryInfo };
  /** Begins an endless walk in the place of the one before. */
  startWalk(uses: number[]): void;
  /** Makes the changes, then computes the next frames. Throws when there is no walk. */
  advanceWalk(changes: WalkChange[], frames: number): Motion;
  learnLibrary(job: LearningJob, report: (report: LibraryReport<string>) => void): Promise<TrainingOutcome>;
  fitCouplings(job: FittingJob, report: (report: LibraryReport<Couplings>) => void): Promise<TrainingOutcome>;
  cancelLibrary(): void;
  /** How well the target is locked to the source at each coupling, 0 to 1. */
  lockingRow(job: LockingJob): Float64Array;
}
