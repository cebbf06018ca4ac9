// A library of primitives from JavaScript: trained, combined, coupled to a clip, and walked through while primitives change.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { installPackage } from "./package.mjs";

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
/** @type {typeof import("vcgpdm")} */
let vcgpdm;
/** @type {import("vcgpdm").Library} */
let library;

const sample = (/** @type {string} */ id) => vcgpdm.Clip.sample(id);
const set = (/** @type {string[]} */ ids) => {
  const clips = new vcgpdm.TrainingSet();
  for (const id of ids) clips.add(sample(id));
  return clips;
};

before(async () => {
  installed = await installPackage();
  vcgpdm = installed.vcgpdm;
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
  };
  const plan = {
    movements: [
      { name: "walk", sequences: 2 },
      { name: "wave", sequences: 2 },
    ],
    shared: [false, false],
  };
  const trainer = new vcgpdm.LibraryTrainer(set(["walk-1", "walk-2", "walk-wave-1", "walk-wave-2"]), settings, plan);
  let progress = trainer.step();
  while (!progress.done) progress = trainer.step();
  library = trainer.library();
});
after(() => installed?.remove());

/** The largest step of some nodes between two frames, in metres. */
function largestStep(
  /** @type {Float32Array[]} */ batches,
  /** @type {number} */ width,
  /** @type {number[]} */ nodes,
) {
  const all = batches.flatMap((batch) => [...batch]);
  let largest = 0;
  for (let frame = width; frame < all.length; frame += width)
    for (const node of nodes) {
      const at = frame + 3 * node;
      const by = [0, 1, 2].map((axis) => (all[at + axis] ?? 0) - (all[at + axis - width] ?? 0));
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
    assert.deepEqual(model.info().alpha, library.nearestCouplings([0, 3]));
    const rollout = model.rollout({ frames: 40, sequence: 0 });
    assert.ok([...rollout.positions()].every(Number.isFinite));
    const extended = library.withCombination("half", [0, 3], model.info().alpha);
    const movement = extended.info().movements[2];
    assert.equal(movement?.name, "half");
    assert.deepEqual(movement?.couplings, { from: "movement", movement: "walk+wave" });
    assert.throws(() => library.combination([0, 0]), { code: "model", message: /expected a primitive of part 1/ });
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
    assert.deepEqual(model.info().alpha, trainer.alpha());
    assert.equal(model.info().sequences[0]?.name, "walk-3 (made by this project).bvh");
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
    walk.mix(1, 2, 0.5);
    walk.setTempo(1, 0.8);
    walk.setAlpha(library.nearestCouplings([0, 3]));
    assert.ok([...walk.advance(40).positions()].every(Number.isFinite));
    assert.throws(() => walk.setTempo(1, 9), { code: "rollout", message: /a tempo from 0.25 to 2, found 9/ });
  });
});
