// What a worker does for libraries of primitives: holds one with its endless walk, learns libraries, fits couplings. No DOM.
import { Clip, CouplingTrainer, Library, LibraryTrainer, type LibraryWalk, TrainingSet } from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type { FittingJob, LearningJob, LibraryReport, LibraryWorker, WalkChange } from "../engine/library-protocol";
import type { Couplings, Motion, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { ClipReader } from "./clip-reader";
import { handOver } from "./hand-over";
import { OneTask, type Task } from "./slices";
import { using } from "./using";

const clips = new ClipReader({ Clip, TrainingSet });
const training = new OneTask();

/** The library that the page shows. */
let held: { library: Library; nodes: number; frameTime: number } | null = null;
let walk: LibraryWalk | null = null;

function current(): NonNullable<typeof held> {
  if (!held) throw new Error("There is no library yet: open one.");
  return held;
}

function endWalk(): void {
  walk?.free();
  walk = null;
}

/** Frames on their way to the page. */
function motionOf(positions: Float32Array, frames: number): Motion {
  const { nodes, frameTime } = current();
  return handOver({ positions, frames, nodes, frameTime }, positions);
}

function change(walk: LibraryWalk, change: WalkChange): void {
  switch (change.kind) {
    case "use":
      walk.use(change.part, change.primitive);
      break;
    case "mix":
      walk.mix(change.part, change.other, change.share);
      break;
    case "couplings":
      walk.setAlpha(change.alpha);
      break;
    case "tempo":
      walk.setTempo(change.part, change.tempo);
      break;
  }
}

interface Steps {
  step(): TrainingProgress;
}

/** Takes steps until they are over or cancelled; the last report brings what was found. */
async function follow<Found>(
  { trainer, find }: { trainer: Steps; find(): Found },
  report: (report: LibraryReport<Found>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const start = performance.now();
  const elapsed = () => (performance.now() - start) / 1000;
  let progress = trainer.step();
  const step = () => {
    if (!progress.done) progress = trainer.step();
    return progress.done;
  };
  const done = await task.inSlices(step, () => report({ progress, elapsed: elapsed(), found: null }));
  // Waits until the page has it: reports and the outcome travel on different ports.
  await report({ progress, elapsed: elapsed(), found: find() });
  return { cancelled: !done, reason: done ? progress.reason : null };
}

async function learn(
  { clips: chosen, settings, movements, shared }: LearningJob,
  report: (report: LibraryReport<string>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const trainer = using(await clips.set(chosen), (set) => new LibraryTrainer(set, settings, { movements, shared }));
  try {
    const find = () => using(trainer.library(), (library) => library.toJson());
    return await follow({ trainer, find }, report, task);
  } finally {
    trainer.free();
  }
}

async function fitCouplings(
  { library, uses, clips: chosen, maxIterations }: FittingJob,
  report: (report: LibraryReport<Couplings>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const set = await clips.set(chosen);
  const trainer = using(set, () =>
    using(Library.fromJson(library), (known) => new CouplingTrainer(known, uses, set, maxIterations)),
  );
  try {
    return await follow({ trainer, find: () => trainer.alpha() }, report, task);
  } finally {
    trainer.free();
  }
}

export const libraryWorker: LibraryWorker = {
  openLibrary(text) {
    const library = Library.fromJson(text);
    const info = library.info();
    if (info.parts.length > MAX_PARTS) {
      library.free();
      throw new Error(`expected a library of ${MAX_PARTS} parts at most, found ${info.parts.length}`);
    }
    endWalk();
    held?.library.free();
    held = { library, nodes: info.figure.nodes.length, frameTime: info.frameTime };
    return info;
  },
  nearestCouplings: (uses) => current().library.nearestCouplings(uses),
  combinationMotion: (uses, frames) =>
    using(current().library.combination(uses), (model) =>
      using(model.rollout({ frames, sequence: 0 }), (rollout) => motionOf(rollout.positions(), frames)),
    ),
  combinationText: (uses, alpha) => using(current().library.combination(uses, alpha), (model) => model.toJson()),
  addCombination(name, uses, alpha) {
    const before = current();
    const library = before.library.withCombination(name, uses, alpha);
    before.library.free();
    held = { ...before, library };
    return { text: library.toJson(), info: library.info() };
  },
  startWalk(uses) {
    const next = current().library.walk(uses);
    endWalk();
    walk = next;
  },
  advanceWalk(changes, frames) {
    if (!walk) throw new Error("There is no walk: start one.");
    for (const one of changes) change(walk, one);
    return using(walk.advance(frames), (next) => motionOf(next.positions(), frames));
  },
  learnLibrary: (job, report) => training.run((task) => learn(job, report, task)),
  fitCouplings: (job, report) => training.run((task) => fitCouplings(job, report, task)),
  cancelLibrary: () => training.cancel(),
  lockingRow({ library, uses, source, target, tempo, strengths }) {
    const row = using(Library.fromJson(library), (known) =>
      known.lockingMap(uses, source, target, Float64Array.of(tempo), Float64Array.from(strengths)),
    );
    return handOver(row, row);
  },
};
