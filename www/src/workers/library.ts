// Libraries of primitives: keeps one open with its endless walk, learns libraries, fits couplings. No DOM.
import { CouplingTrainer, type Endless, Library, type LibraryInfo, LibraryTrainer } from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type { FittingJob, LearningJob, LibraryWorker, RecordedMovement } from "../engine/library-protocol";
import type { LiveBody, Motion } from "../engine/protocol";
import { clipSet } from "./clips";
import { advance, type PrimitivesChange } from "./endless";
import { follow } from "./follow";
import { inSlices } from "./slices";
import { transfer, using } from "./using";

/** The library that the page shows. */
let open: { library: Library; body: LiveBody } | null = null;
let walk: Endless | null = null;

function current(): NonNullable<typeof open> {
  if (!open) throw new Error("There is no library yet: open one.");
  return open;
}

function endWalk(): void {
  walk?.free();
  walk = null;
}

/** Frames on their way to the page. */
function motionOf(positions: Float32Array, frames: number): Motion {
  const { figure, frameTime } = current().body;
  return transfer({ positions, frames, nodes: figure.nodes.length, frameTime }, positions);
}

function exchangePrimitives(walk: Endless, change: PrimitivesChange): void {
  if (change.kind === "use") walk.use(change.part, change.primitive);
  else
    walk.setCouplings(
      Float64Array.from(
        current()
          .library.nearestCouplings([...change.uses])
          .flat(),
      ),
      false,
    );
}

async function learner({ clips: chosen, settings, movements, shared }: LearningJob): Promise<LibraryTrainer> {
  return using(await clipSet(chosen), (set) => new LibraryTrainer(set, settings, { movements, shared }));
}

async function fitter({ library, uses, clips: chosen, maxIterations }: FittingJob): Promise<CouplingTrainer> {
  return using(await clipSet(chosen), (set) =>
    using(Library.fromJson(library), (parsed) => new CouplingTrainer(parsed, uses, set, maxIterations)),
  );
}

/** Opens another library of the same body in the place of the one before; the walk continues. */
function exchange(library: Library): { text: string; info: LibraryInfo } {
  const before = current();
  walk?.setLibrary(library);
  before.library.free();
  open = { ...before, library };
  return { text: library.toJson(), info: library.info() };
}

const isWhole = ({ parts, primitives }: LibraryInfo) =>
  parts.every((_, part) => primitives.some((one) => one.part === part));

/** Seconds of a clip that a model makes. */
const CLIP_SECONDS = 5;

function movementOf(library: Library, place: number, name: string): RecordedMovement {
  const { frameTime, movements } = library.info();
  const frames = Math.round(CLIP_SECONDS / frameTime);
  return using(library.movement(place), (model) => ({
    name,
    model: model.toJson(),
    clips: (movements[place]?.sequences ?? []).map((_, sequence) =>
      using(model.rollout({ frames, sequence }), (rollout) => rollout.toBvh()),
    ),
  }));
}

export const libraryWorker: LibraryWorker = {
  recordedMovements: (text) =>
    using(Library.fromJson(text), (library) =>
      library
        .info()
        .movements.flatMap(({ learned, name }, place) => (learned ? [movementOf(library, place, name)] : [])),
    ),
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
    open?.library.free();
    open = { library, body: info };
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
  addPrimitives: (text) => using(Library.fromJson(text), (other) => exchange(current().library.add(other))),
  startWalk(uses) {
    const next = current().library.walk(uses);
    endWalk();
    walk = next;
  },
  advanceWalk(step) {
    const endless = walk;
    if (!endless) throw new Error("There is no walk: start one.");
    return advance(endless, current().body, step, (change) => exchangePrimitives(endless, change));
  },
  learnLibrary: async (job, report, signal) =>
    using(await learner(job), (trainer) => {
      const find = () => using(trainer.library(), (library) => library.toJson());
      const notices = () => trainer.notices();
      return follow({ step: () => trainer.step(), notices, find }, report, signal);
    }),
  fitCouplings: async (job, report, signal) =>
    using(await fitter(job), (trainer) => {
      const find = () =>
        using(trainer.library(""), (fitted) => {
          const { alpha, couplings: from } = fitted.info().movements.at(-1) ?? {
            alpha: [],
            couplings: { from: "nothing" },
          };
          return { alpha, from };
        });
      return follow({ step: () => trainer.step(), find }, report, signal);
    }),
  recognise: async ({ library, clips }, report, signal) =>
    using(await clipSet(clips), (set) =>
      using(Library.fromJson(library), (parsed) =>
        using(parsed.recogniser(set), async (recogniser) => {
          let fraction = 0;
          const step = () => {
            fraction = recogniser.step();
            return fraction === 1;
          };
          if (!(await inSlices(signal, step, () => void report(fraction)))) return null;
          const { figure, frameTime } = parsed.info();
          return using(recogniser.finish(), (found) => {
            const positions = found.positions();
            const motion = { positions, frames: found.frames, nodes: figure.nodes.length, frameTime };
            return transfer({ motion, segments: found.segments() }, positions);
          });
        }),
      ),
    ),
};
