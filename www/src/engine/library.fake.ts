// For tests: a library of two parts with two primitives each, in a worker that computes nothing.
import type {
  CouplingsFrom,
  Fitted,
  FittingJob,
  LearningJob,
  LibraryInfo,
  LibraryWorker,
  PartMotion,
  PrimitiveOrigin,
  RecognisedSegment,
  RecognitionJob,
} from "./library-protocol";
import type { Couplings, Motion, Report, TrainingOutcome, TrainingReport } from "./protocol";
import type { Calls } from "./calls";
import { FakeLive, figure, joints, liveFrames } from "./engine.fake";

/** A training that the test ends. */
export interface PendingTraining<Job, Found> {
  job: Job;
  report(report: TrainingReport<Found>): unknown;
  end(outcome: TrainingOutcome): void;
}

/**
 * The document of a library: its name, the movements added to the two recorded ones, and the primitives of
 * the upper body added to the first two.
 */
export function libraryText(
  name: string,
  added: readonly string[] = [],
  arms: readonly string[] = [],
): string {
  return JSON.stringify({ name, added, arms });
}

/** A file with only a primitive of the upper body. */
export const armsText = (name: string) => JSON.stringify({ arms: [name], alone: true });

interface FakeText {
  name: string;
  added: string[];
  arms: string[];
  alone?: boolean;
}

const origin: PrimitiveOrigin = {
  ...{ engine: "vcgpdm", seed: 1, bound: 0, iterations: 9, note: null, clips: [], relearned: null },
};

function infoOf(text: string): LibraryInfo {
  const { added, arms } = JSON.parse(text) as FakeText;
  const movement = (name: string, uses: number[], learned: boolean) => ({
    ...{ name, uses, learned, alpha: COUPLINGS, sequences: [] },
    couplings: { from: "nothing" as const },
  });
  return {
    parts: ["lower", "upper"].map((name, joint) => ({ name, joints: [joint], latent: 2, poseIps: 4 })),
    primitives: ["walk", "wave", "walk", "wave", ...arms].map((name, i) => ({
      name,
      part: i < 2 ? 0 : 1,
      origin,
    })),
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
  /** The documents that the worker opened, in order. */
  readonly opened: string[] = [];
  /** The walk now, and the primitives with which walks began. */
  live = new FakeLive();
  readonly walks: number[][] = [];
  readonly learnings: PendingTraining<LearningJob, string>[] = [];
  readonly fittings: PendingTraining<FittingJob, Fitted>[] = [];
  /** The origins of the couplings of added combinations. */
  readonly origins: (CouplingsFrom | null)[] = [];
  /** The reason why primitives of another file do not fit; empty if they fit. */
  misfit = "";
  /** The long-run motion of every combination. */
  moves: PartMotion[] = [];
  readonly recognitions: RecognitionJob[] = [];
  /** What is recognised in every recording: the movement of each of its frames. */
  recognised: number[] = [0, 0, 1, 1, 1, 0];
  /** The reason why documents are refused; empty if they are accepted. */
  refused = "";
  /** The error of the next frames; empty if they arrive. */
  broken = "";

  /** A new worker without a library. */
  worker(): Calls<LibraryWorker> {
    let held: string | null = null;
    let uses: readonly number[] | null = null;
    const text = () => {
      if (held === null) throw new Error("There is no library yet: open one.");
      return held;
    };
    /** Each combination has another position. */
    const motion = (uses: readonly number[], frames: number): Motion => ({
      ...{ frames, nodes: 2, frameTime: 1 / 30 },
      positions: new Float32Array(frames * 6).fill(uses.reduce((sum, primitive) => sum + primitive, 0)),
    });
    return {
      recordedMovements: async (text) => {
        if (this.refused) throw new Error(this.refused);
        return infoOf(text).movements.flatMap(({ name, learned }) =>
          learned ? [{ name, model: `model of ${name}`, clips: [`bvh of ${name}`] }] : [],
        );
      },
      openLibrary: async (text) => {
        if (this.refused) throw new Error(this.refused);
        this.opened.push(text);
        [held, uses] = [text, null];
        return infoOf(text);
      },
      isWholeLibrary: async (text) => {
        if (this.refused) throw new Error(this.refused);
        return !(JSON.parse(text) as FakeText).alone;
      },
      combinationMoves: async () => (text() ? this.moves : []),
      nearestCouplings: async () => (text() ? COUPLINGS : []),
      combinationMotion: async (uses, frames) => (text() ? motion(uses, frames) : motion([], 0)),
      combinationText: async (uses, alpha) => JSON.stringify({ library: text(), uses, alpha }),
      addCombination: async (name, _uses, _alpha, from) => {
        const { name: of, added, arms } = JSON.parse(text()) as FakeText;
        this.origins.push(from);
        held = libraryText(of, [...added, name], arms);
        return { text: held, info: infoOf(held) };
      },
      primitivesText: async (primitives) => {
        const { primitives: known } = infoOf(text());
        return armsText(primitives.map((primitive) => known[primitive]?.name).join());
      },
      addPrimitives: async (other) => {
        const { name: of, added, arms } = JSON.parse(text()) as FakeText;
        const { arms: more, alone } = JSON.parse(other) as FakeText;
        if (this.misfit && alone) throw new Error(this.misfit);
        const fresh = more.filter((name) => !arms.includes(name));
        held = libraryText(of, added, [...arms, ...fresh]);
        return { text: held, info: infoOf(held) };
      },
      startWalk: async (asked) => {
        text();
        uses = asked;
        this.live = new FakeLive();
        this.walks.push(asked);
      },
      advanceWalk: async (step) => {
        if (this.broken) throw new Error(this.broken);
        if (!uses) throw new Error("There is no walk: start one.");
        this.live.take(step);
        const { changes } = this.live;
        const now = [...uses];
        for (const change of changes) if (change.kind === "use") now[change.part] = change.primitive;
        return liveFrames(motion(now, step.frames), changes);
      },
      learnLibrary: (job, report, signal) => pending(this.learnings, job, report, signal),
      fitCouplings: (job, report, signal) => pending(this.fittings, job, report, signal),
      recognise: async (job, report, signal) => {
        if (this.broken) throw new Error(this.broken);
        this.recognitions.push(job);
        report(0.5);
        await Promise.resolve();
        if (signal.aborted) return null;
        const segments: RecognisedSegment[] = [];
        for (const [frame, movement] of this.recognised.entries()) {
          const last = segments.at(-1);
          const { uses = [] } = infoOf(job.library).movements[movement] ?? {};
          if (last?.movement === movement) last.end = frame + 1;
          else segments.push({ movement, uses, first: frame, end: frame + 1, probability: 1 });
        }
        return { motion: motion([0], this.recognised.length), segments };
      },
    };
  }
}

function pending<Job, Found>(
  list: PendingTraining<Job, Found>[],
  job: Job,
  report: Report<Found>,
  signal: AbortSignal,
): Promise<TrainingOutcome> {
  return new Promise((end) => {
    list.push({ job, report, end });
    signal.addEventListener("abort", () => end({ cancelled: true, reason: null }), { once: true });
  });
}
