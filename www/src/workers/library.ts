// What a worker does for libraries of primitives: holds one with its endless walk, learns libraries, fits
// couplings. No DOM.
import {
  Clip,
  CouplingTrainer,
  ImportTrainer,
  Library,
  type LibraryInfo,
  LibraryTrainer,
  type LibraryWalk,
  ModularityTraining,
  TrainingSet,
} from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type {
  Fitted,
  FittingJob,
  ImportJob,
  Imported,
  LearningJob,
  LibraryReport,
  LibraryWorker,
  ModularityFold,
  ModularityOutcome,
  WalkChange,
} from "../engine/library-protocol";
import type { Motion, TrainingOutcome } from "../engine/protocol";
import { ClipReader } from "./clip-reader";
import { follow } from "./follow";
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

/**
 * A part takes so many frames to go all the way to another of its primitives: at once it would jump.
 * tests/node/library.test.mjs has how far.
 */
const MIX_FRAMES = 45;

function change(walk: LibraryWalk, change: WalkChange): void {
  switch (change.kind) {
    case "use":
      walk.use(change.part, change.primitive);
      break;
    case "mix":
      walk.mix(change.part, change.other, change.share, MIX_FRAMES);
      break;
    case "couplings":
      walk.setAlpha(change.alpha);
      break;
    case "nearest":
      walk.setAlpha(current().library.nearestCouplings([...change.uses]));
      break;
    case "tempo":
      walk.setTempo(change.part, change.tempo);
      break;
  }
}

async function learn(
  { clips: chosen, settings, movements, shared }: LearningJob,
  report: (report: LibraryReport<string>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const trainer = using(
    await clips.set(chosen),
    (set) => new LibraryTrainer(set, settings, { movements, shared }),
  );
  try {
    const find = () => using(trainer.library(), (library) => library.toJson());
    return await follow({ trainer, find }, report, task);
  } finally {
    trainer.free();
  }
}

async function fitCouplings(
  { library, uses, clips: chosen, maxIterations }: FittingJob,
  report: (report: LibraryReport<Fitted>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const set = await clips.set(chosen);
  const trainer = using(set, () =>
    using(Library.fromJson(library), (known) => new CouplingTrainer(known, uses, set, maxIterations)),
  );
  try {
    const find = () =>
      using(trainer.library(""), (fitted) => {
        const { alpha, couplings: from } = fitted.info().movements.at(-1) ?? {
          alpha: [],
          couplings: { from: "nothing" },
        };
        return { alpha, from };
      });
    return await follow({ trainer, find }, report, task);
  } finally {
    trainer.free();
  }
}

async function importPrimitives(
  { library, other, clips: chosen, maxIterations, seed }: ImportJob,
  report: (report: LibraryReport<Imported>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const set = chosen.length > 0 ? await clips.set(chosen) : null;
  const request = { maxIterations, seed };
  const begin = (host: Library, donor: Library) =>
    set
      ? using(set, () => ImportTrainer.fromClips(host, donor, set, request))
      : new ImportTrainer(host, donor, request);
  const trainer = using(Library.fromJson(library), (host) =>
    using(Library.fromJson(other), (donor) => begin(host, donor)),
  );
  try {
    const find = () => ({
      text: using(trainer.library(), (found) => found.toJson()),
      lost: [...trainer.lost()],
    });
    return await follow({ trainer, find }, report, task);
  } finally {
    trainer.free();
  }
}

async function holdOut(
  fold: ModularityFold,
  report: (report: LibraryReport<ModularityOutcome>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const training = new ModularityTraining(fold);
  let done = false;
  const step = () => {
    const progress = training.step();
    done = progress.done;
    return progress;
  };
  try {
    // A training that was broken off is no measurement.
    return await follow({ trainer: { step }, find: () => (done ? training.outcome() : null) }, report, task);
  } finally {
    training.free();
  }
}

/**
 * Holds another library in the place of the one before, of the same body; the walk goes on among the
 * primitives that were there.
 */
function exchange(library: Library): { text: string; info: LibraryInfo } {
  const before = current();
  walk?.setLibrary(library);
  before.library.free();
  held = { ...before, library };
  return { text: library.toJson(), info: library.info() };
}

const isWhole = ({ parts, primitives }: LibraryInfo) =>
  parts.every((_, part) => primitives.some((one) => one.part === part));

export const libraryWorker: LibraryWorker = {
  isWholeLibrary: (text) => using(Library.fromJson(text), (library) => isWhole(library.info())),
  openLibrary(text) {
    const library = Library.fromJson(text);
    const info = library.info();
    if (info.parts.length > MAX_PARTS) {
      library.free();
      throw new Error(`expected a library of ${MAX_PARTS} parts at most, found ${info.parts.length}`);
    }
    if (!isWhole(info)) {
      library.free();
      throw new Error("expected a primitive of every part of the body; these can be added to a library");
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
  combinationMoves: (uses, alpha) => current().library.motion(uses, alpha),
  combinationText: (uses, alpha) =>
    using(current().library.combination(uses, alpha), (model) => model.toJson()),
  addCombination: (name, uses, alpha, from) =>
    exchange(current().library.withCombination(name, uses, alpha, from)),
  primitivesText: (primitives) => using(current().library.select(primitives), (some) => some.toJson()),
  addPrimitives: (text) =>
    using(Library.fromJson(text), (other) => {
      const { library } = current();
      const misfit = library.misfit(other);
      if (misfit) return { misfit };
      const before = library.info().primitives.length;
      const { text, info } = exchange(library.add(other));
      return { text, info, added: info.primitives.length - before };
    }),
  importPrimitives: (job, report) => training.run((task) => importPrimitives(job, report, task)),
  startWalk(uses) {
    const next = current().library.walk(uses);
    endWalk();
    walk = next;
  },
  advanceWalk(back, changes, frames) {
    if (!walk) throw new Error("There is no walk: start one.");
    if (back > 0) walk.rewind(back);
    for (const one of changes) change(walk, one);
    return using(walk.advance(frames), (next) => motionOf(next.positions(), frames));
  },
  learnLibrary: (job, report) => training.run((task) => learn(job, report, task)),
  fitCouplings: (job, report) => training.run((task) => fitCouplings(job, report, task)),
  holdOut: (fold, report) => training.run((task) => holdOut(fold, report, task)),
  cancelLibrary: () => training.cancel(),
  lockingRow({ library, uses, source, target, tempo, strengths }) {
    const row = using(Library.fromJson(library), (known) =>
      known.lockingMap(uses, source, target, Float64Array.of(tempo), Float64Array.from(strengths)),
    );
    return handOver(row, row);
  },
};
