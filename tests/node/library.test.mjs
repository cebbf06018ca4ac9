// A library of primitives from JavaScript: trained, combined, coupled to a clip, and walked through while
// primitives change.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { coupledInfo } from "./package.mjs";

const vcgpdm = builtPackage();
/** @type {import("vcgpdm").Library} */
let library;

const sample = (/** @type {string} */ id) => vcgpdm.Clip.sample(id);
const set = (/** @type {string[]} */ ids) => {
  const clips = new vcgpdm.TrainingSet();
  for (const id of ids) clips.add(sample(id));
  return clips;
};

before(async () => {
  const preset = sample("walk-1")
    .info()
    .presets.find(({ id }) => id === "lower-upper");
  assert.ok(preset);
  const settings = {
    parts: preset.parts,
    latent: 2,
    dynamicsIps: 8,
    poseIps: 8,
    order: 2,
    framesPerSecond: 20,
    seed: 1,
    maxIterations: 60,
    // Recognition is tested on what the bound gives.
    ownRollouts: false,
  };
  const plan = {
    movements: [
      { name: "walk", sequences: 2 },
      { name: "wave", sequences: 2 },
    ],
    shared: [false, false],
  };
  const trainer = new vcgpdm.LibraryTrainer(
    set(["walk-1", "walk-2", "walk-wave-1", "walk-wave-2"]),
    settings,
    plan,
  );
  let progress = trainer.step();
  while (!progress.done) progress = trainer.step();
  library = trainer.library();
});

/** The largest step of some nodes between two frames, in metres. */
function largestStep(
  /** @type {Float32Array[]} */ batches,
  /** @type {number} */ width,
  /** @type {number[]} */ nodes = Array.from({ length: width / 3 }, (_, node) => node),
) {
  const all = batches.flatMap((batch) => [...batch]);
  let largest = 0;
  for (let frame = width; frame < all.length; frame += width)
    for (const node of nodes) {
      const place = frame + 3 * node;
      const by = [0, 1, 2].map((axis) => (all[place + axis] ?? 0) - (all[place + axis - width] ?? 0));
      largest = Math.max(largest, Math.hypot(...by));
    }
  return largest;
}

describe("a library of primitives", () => {
  it("names its primitives and movements, and comes back from its document", () => {
    const info = library.info();
    assert.deepEqual(
      info.primitives.map(({ part, name }) => [part, name]),
      [
        [0, "walk"],
        [0, "wave"],
        [1, "walk"],
        [1, "wave"],
      ],
    );
    assert.deepEqual(
      info.movements.map(({ name, uses, learned, couplings }) => [name, uses, learned, couplings.from]),
      [
        ["walk", [0, 2], true, "training"],
        ["wave", [1, 3], true, "training"],
      ],
    );
    const again = vcgpdm.Library.fromJson(library.toJson());
    assert.equal(again.toJson(), library.toJson());
    assert.throws(() => vcgpdm.Library.fromJson(library.movement(0).toJson()), {
      code: "model",
      message: /expected a library of primitives, found a vcgpdm model/,
    });
  });

  it("makes a model of a combination that was never recorded", () => {
    const model = library.combination([0, 3]);
    assert.deepEqual(coupledInfo(model).alpha, library.nearestCouplings([0, 3]));
    const rollout = model.rollout({ frames: 40, sequence: 0 });
    assert.ok([...rollout.positions()].every(Number.isFinite));
    // A learned movement keeps its name: with it went where its primitives come from.
    const learned = library.info().movements.find((movement) => movement.learned)?.name ?? "";
    assert.throws(() => library.withCombination(learned, [0, 3], coupledInfo(model).alpha), {
      code: "model",
      message: `expected a name that no learned movement has, found "${learned}"`,
    });
    const extended = library.withCombination("half", [0, 3], coupledInfo(model).alpha);
    const movement = extended.info().movements[2];
    assert.equal(movement?.name, "half");
    assert.deepEqual(movement?.couplings, { from: "movement", movement: "walk+wave" });
    assert.throws(() => library.combination([0, 0]), {
      code: "model",
      message: /expected a primitive of part 1/,
    });
    assert.throws(() => library.combination([0, 3], [[1]]), {
      code: "model",
      message: /expected coupling variances for 2 x 2 parts/,
    });
  });

  it("fits the couplings of a combination to a clip", () => {
    const trainer = new vcgpdm.CouplingTrainer(library, [0, 2], set(["walk-3"]), 30);
    const first = trainer.step().bound;
    let progress = trainer.step();
    while (!progress.done) progress = trainer.step();
    assert.ok(progress.best > first);
    const model = trainer.model();
    assert.deepEqual(coupledInfo(model).alpha, trainer.alpha());
    assert.equal(coupledInfo(model).sequences[0]?.name, "walk-3 (made by this project).bvh");
    assert.equal(trainer.library("third").info().movements.at(-1)?.couplings.from, "clips");
  });

  it("walks on while a part is given another primitive: the other part does not jump", () => {
    const { parts, figure } = library.info();
    const legs = figure.nodes.flatMap(({ joint }, node) => (parts[0]?.joints.includes(joint) ? [node] : []));
    assert.ok(legs.length > 4);
    const walk = library.walk([0, 2]);
    const before = walk.advance(40).positions();
    const width = before.length / 40;
    walk.use(1, 3);
    const after = walk.advance(40).positions();
    assert.ok(largestStep([before, after], width, legs) < 1.3 * largestStep([before], width, legs));
    walk.setTempo(1, 0.8);
    walk.setCouplings(Float64Array.from(library.nearestCouplings([0, 3]).flat()), false);
    assert.ok([...walk.advance(40).positions()].every(Number.isFinite));
    assert.throws(() => walk.setTempo(1, 9), { code: "rollout", message: /a tempo from 0.25 to 2, found 9/ });
  });

  it("lets a driven part go where its new primitive goes round no cycle", () => {
    const first = vcgpdm.Library.fromJson(readFileSync(at("www/first/library.json"), "utf8"));
    const of = (/** @type {number} */ part) =>
      first.info().primitives.flatMap((primitive, i) => (primitive.part === part ? [i] : []));
    const walk = first.walk([of(0)[0] ?? 0, of(1)[0] ?? 0]);
    for (const legs of of(0)) {
      walk.drive(0, 0.1);
      walk.use(0, legs);
      assert.ok([...walk.advance(3).positions()].every(Number.isFinite));
      walk.use(0, of(0)[0] ?? 0);
    }
  });

  it("says where a combination stands still, and to whom its parts listen", () => {
    const [legs, arms] = library.motion([0, 2]);
    assert.ok(legs && arms && !legs.still && legs.share > 0.3);
    assert.deepEqual([arms.leader?.part, arms.leader?.met], [0, true]);
    assert.equal(library.motion([0, 3])[1]?.leader?.met, false);
    assert.throws(() => library.motion([0]), { code: "model" });
  });

  it("begins a walk at a frame of a movement, and changes a primitive together with couplings", () => {
    const first = library.walk([0, 2], { movement: 0, sequence: 1, frame: 12 }).advance(1).latents(0);
    const other = library.walk([0, 2]).advance(1).latents(0);
    assert.notDeepEqual([...first], [...other]);
    assert.throws(() => library.walk([0, 2], { movement: 0, sequence: 9 }), {
      message: /a sequence of the movement from 0 to 1, found 9/,
    });
    const walk = library.walk([0, 2]);
    walk.use(1, 3, library.nearestCouplings([0, 3]));
    assert.throws(() => walk.use(1, 2, [[1]]), { message: /expected coupling variances for 2 x 2 parts/ });
    const expected = library.walk([0, 2]);
    expected.use(1, 3);
    expected.setCouplings(Float64Array.from(library.nearestCouplings([0, 3]).flat()), false);
    assert.deepEqual([...walk.advance(5).positions()], [...expected.advance(5).positions()]);
  });

  it("takes the last frames of a walk back, with what was changed since", () => {
    const walk = library.walk([0, 2]);
    const frames = [...walk.advance(10).positions()];
    walk.use(1, 3);
    walk.advance(5);
    walk.rewind(8);
    const again = [...walk.advance(3).positions()];
    assert.deepEqual(again, frames.slice(-again.length));
    assert.throws(() => walk.rewind(11), {
      code: "rollout",
      message: /frames to take back from 0 to 10, found 11/,
    });
  });

  it("says where couplings of a combination come from that is added", () => {
    const alpha = [
      [1, 2],
      [3, 4],
    ];
    const from = (/** @type {import("vcgpdm").CouplingsFrom | undefined} */ couplings) =>
      library.withCombination("own", [0, 3], alpha, couplings).info().movements.at(-1)?.couplings;
    assert.deepEqual(from(undefined), { from: "hand" });
    assert.deepEqual(from({ from: "clips", bound: 3, iterations: 4 }), {
      from: "clips",
      bound: 3,
      iterations: 4,
    });
    // @ts-expect-error: of no kind that there is
    assert.throws(() => from({ from: "afar" }), { code: "model" });
  });

  it("says which of its movements clips show, one after the other", () => {
    const clips = set(["walk-3", "walk-wave-3"]);
    const found = library.recognise(clips);
    const segments = found.segments();
    assert.deepEqual(
      segments.map(({ movement }) => movement),
      [0, 1],
    );
    const { figure, frameTime, movements, primitives } = library.info();
    assert.deepEqual(
      segments.map(({ uses }) => uses),
      movements.slice(0, 2).map(({ uses }) => uses),
    );
    const seconds = sample("walk-3").info().frames * sample("walk-3").info().frameTime;
    assert.ok(Math.abs((segments[0]?.end ?? 0) * frameTime - seconds) < 0.3);
    assert.equal(segments.at(-1)?.end, found.frames);
    assert.equal(found.positions().length, found.frames * figure.nodes.length * 3);
    const upper = primitives.filter(({ part }) => part === 1).length;
    const probabilities = found.probabilities(1);
    assert.equal(probabilities.length, found.frames * upper);
    const first = probabilities.subarray(0, upper);
    assert.ok(Math.abs(first.reduce((sum, p) => sum + p, 0) - 1) < 1e-9);
    assert.ok((first[0] ?? 0) > 0.5);
    assert.throws(() => found.probabilities(2), { code: "clips", message: /expected a part from 0 to 1/ });
    assert.throws(() => library.recognise(new vcgpdm.TrainingSet()), {
      code: "clips",
      message: /expected one clip or more, found none/,
    });
  });
});

/** Takes steps until the end. */
function finish(/** @type {{ step(): import("vcgpdm").TrainingProgress }} */ trainer) {
  let progress = trainer.step();
  while (!progress.done) progress = trainer.step();
  return progress;
}

describe("primitives on their way", () => {
  it("are saved alone and come back into what was left of their library", () => {
    const arms = vcgpdm.Library.fromJson(library.select([3]).toJson());
    assert.deepEqual(
      arms.info().primitives.map(({ part, name, origin }) => [part, name, origin.seed, origin.clips.length]),
      [[1, "wave", 1, 2]],
    );
    const rest = library.select([0, 1, 2]);
    const walk = rest.walk([0, 2]);
    walk.advance(5);
    const whole = rest.add(arms);
    assert.deepEqual(
      whole.info().primitives.map(({ name }) => name),
      ["walk", "wave", "walk", "wave"],
    );
    assert.equal(whole.nearestCouplings([0, 3])[1]?.[1], library.nearestCouplings([0, 3])[1]?.[1]);
    assert.throws(() => walk.use(1, 3), { message: /expected a primitive of part 1, found primitive 3/ });
    walk.setLibrary(whole);
    walk.use(1, 3);
    assert.ok([...walk.advance(20).positions()].every(Number.isFinite));
    assert.throws(() => walk.setLibrary(arms), {
      message: /expected a library with all primitives of the one before/,
    });
    assert.throws(() => library.select([]), { code: "model", message: /one or more, found none/ });
  });

  it("learn from the rollouts of movements that would stop", () => {
    const { settings } = library.info().provenance;
    const movements = [{ name: "walk" }, { name: "wave" }];
    const trainer = new vcgpdm.LibraryTrainer(
      set(["walk-1", "stand-wave-1"]),
      { ...settings, latent: 3, framesPerSecond: 30, seed: 0, maxIterations: 20, ownRollouts: true },
      { movements },
    );
    while (trainer.step().phase !== "own-rollouts");
    const endings = (/** @type {import("vcgpdm").Library} */ trained) =>
      movements.map((_, place) => trained.movement(place).rollout({ frames: 600 }).health().state);
    assert.deepEqual(endings(trainer.library()), ["keeps-one-pose", "stands-still"]);
    while (!trainer.step().done);
    assert.deepEqual(endings(trainer.library()), ["moves-on", "moves-on"]);
  });

  it("of another training are refused with the reason", () => {
    const { settings } = library.info().provenance;
    const plan = { movements: [{ name: "stroll", sequences: 1 }], shared: [false, false] };
    const trainer = new vcgpdm.LibraryTrainer(
      set(["walk-3"]),
      { ...settings, latent: 3, maxIterations: 40 },
      plan,
    );
    finish(trainer);
    const legs = trainer.library().select([0]);
    assert.throws(() => library.add(legs), { code: "model", message: /latent dimensions of lower differ/ });
  });
});
