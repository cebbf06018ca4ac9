// For tests: a library of two parts with two primitives each, in a worker that computes nothing.
import type { FittingJob, LearningJob, LibraryInfo, LibraryReport, LockingJob, WalkChange } from "./library-protocol";
import type { Couplings, Motion, TrainingOutcome } from "./protocol";
import type { WholeProgramWorker } from "./whole-engine";

type LibraryCalls =
  | "openLibrary"
  | "nearestCouplings"
  | "combinationMotion"
  | "combinationText"
  | "addCombination"
  | "startWalk"
  | "advanceWalk"
  | "learnLibrary"
  | "fitCouplings"
  | "lockingRow";

/** Training that a test brings to its end. */
export interface PendingTraining<Job, Found> {
  job: Job;
  report(report: LibraryReport<Found>): void;
  end(outcome: TrainingOutcome): void;
}

const joints = ["hips", "chest"].map((name, joint) => ({ name, parent: joint === 0 ? null : 0, channels: [] }));
const figure = {
  nodes: [
    { joint: 0, parent: null, endSite: false },
    { joint: 1, parent: 0, endSite: false },
  ],
};

/** A library's document: what it is called, and its movements beside the two that were recorded. */
export function libraryText(name: string, added: readonly string[] = []): string {
  return JSON.stringify({ name, added });
}

function infoOf(text: string): LibraryInfo {
  const { added } = JSON.parse(text) as { added: string[] };
  const movement = (name: string, uses: number[], learned: boolean) => ({
    ...{ name, uses, learned, alpha: COUPLINGS, sequences: [] },
    couplings: { from: "nothing" as const },
  });
  return {
    parts: ["lower", "upper"].map((name, joint) => ({ name, joints: [joint], latent: 2, poseIps: 4 })),
    primitives: ["walk", "wave", "walk", "wave"].map((name, i) => ({ name, part: i < 2 ? 0 : 1 })),
    movements: [
      movement("walk", [0, 2], true),
      movement("wave", [1, 3], true),
      ...added.map((name) => movement(name, [0, 3], false)),
    ],
    order: 2,
    frameTime: 1 / 30,
    joints,
    figure,
    provenance: {} as LibraryInfo["provenance"],
  };
}

const COUPLINGS: Couplings = [
  [1, 2],
  [3, 4],
];

export class FakeLibraries {
  /** What the worker was asked to hold, in order. */
  readonly opened: string[] = [];
  /** All changes of walks, and where walks began. */
  readonly changes: WalkChange[] = [];
  readonly walks: number[][] = [];
  readonly learnings: PendingTraining<LearningJob, string>[] = [];
  readonly fittings: PendingTraining<FittingJob, Couplings>[] = [];
  readonly rows: LockingJob[] = [];
  /** Why documents are refused; empty when they are not. */
  refused = "";
  /** Why the next frames do not come; empty when they do. */
  broken = "";

  /** A worker that has just started: it holds nothing. */
  worker(): Pick<WholeProgramWorker, LibraryCalls> {
    let held: string | null = null;
    let uses: readonly number[] | null = null;
    const text = () => {
      if (held === null) throw new Error("There is no library yet: open one.");
      return held;
    };
    /** Each combination stands somewhere else. */
    const motion = (uses: readonly number[], frames: number): Motion => ({
      ...{ frames, nodes: 2, frameTime: 1 / 30 },
      positions: new Float32Array(frames * 6).fill(uses.reduce((sum, primitive) => sum + primitive, 0)),
    });
    return {
      openLibrary: async (text) => {
        if (this.refused) throw new Error(this.refused);
        this.opened.push(text);
        [held, uses] = [text, null];
        return infoOf(text);
      },
      nearestCouplings: async () => (text() ? COUPLINGS : []),
      combinationMotion: async (uses, frames) => (text() ? motion(uses, frames) : motion([], 0)),
      combinationText: async (uses, alpha) => JSON.stringify({ library: text(), uses, alpha }),
      addCombination: async (name) => {
        const { name: of, added } = JSON.parse(text()) as { name: string; added: string[] };
        held = libraryText(of, [...added, name]);
        return { text: held, info: infoOf(held) };
      },
      startWalk: async (asked) => {
        text();
        uses = asked;
        this.walks.push(asked);
      },
      advanceWalk: async (changes, frames) => {
        if (this.broken) throw new Error(this.broken);
        if (!uses) throw new Error("There is no walk: start one.");
        this.changes.push(...changes);
        for (const change of changes)
          if (change.kind === "use") uses = uses.map((one, part) => (part === change.part ? change.primitive : one));
        return motion(uses, frames);
      },
      learnLibrary: (job, report, signal) => pending(this.learnings, job, report, signal),
      fitCouplings: (job, report, signal) => pending(this.fittings, job, report, signal),
      lockingRow: async (job) => {
        this.rows.push(job);
        return Float64Array.from(job.strengths, () => 1 / job.tempo);
      },
    };
  }
}

function pending<Job, Found>(
  list: PendingTraining<Job, Found>[],
  job: Job,
  report: (report: LibraryReport<Found>) => void,
  signal: AbortSignal,
): Promise<TrainingOutcome> {
  return new Promise((end) => {
    list.push({ job, report, end });
    signal.addEventListener("abort", () => end({ cancelled: true, reason: null }), { once: true });
  });
}
