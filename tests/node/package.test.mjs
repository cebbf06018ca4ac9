// What a Node user does with the package: read a BVH, train, roll out, save the model, load it again.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { before, describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { coupledInfo, installedPackage } from "./package.mjs";

const installed = await installedPackage();
/** @type {typeof import("vcgpdm")} */
let vcgpdm;

before(async () => {
  vcgpdm = installed.vcgpdm;
});

/** The bundled walk as the text of a BVH file. */
const walkBvh = () => {
  const walk = vcgpdm.Clip.samples().find(({ movement }) => movement === "walk");
  assert.ok(walk, "a bundled clip of a walk");
  return vcgpdm.Clip.sample(walk.id).toBvh();
};
const read = (/** @type {string} */ name, /** @type {string} */ text) =>
  vcgpdm.Clip.read(name, new TextEncoder().encode(text));

/**
 * A small model of the bundled walk, trained for a few iterations, and how the bound went.
 * @param {Partial<import("vcgpdm").TrainingSettings>} more
 */
function train(seed = 1, more = {}) {
  const clip = read("walk.bvh", walkBvh()).cut(0, 60);
  const clips = new vcgpdm.TrainingSet();
  clips.add(clip);
  const preset = clip.info().presets.find(({ id }) => id === "lower-upper");
  assert.ok(preset, "the walker's joint names give a lower and an upper body");
  const maxIterations = 8;
  const trainer = new vcgpdm.Trainer(clips, {
    parts: preset.parts,
    latent: 2,
    dynamicsIps: 6,
    poseIps: 6,
    order: 2,
    framesPerSecond: 30,
    seed,
    maxIterations,
    ...more,
  });
  const progress = [trainer.step()];
  while (!progress.at(-1)?.done) {
    assert.ok(progress.length <= 4 * maxIterations, "training ends");
    progress.push(trainer.step());
  }
  return { model: trainer.model(), progress, trainer };
}

const finite = (/** @type {ArrayLike<number>} */ numbers) => Array.from(numbers).every(Number.isFinite);

it("rolls out from any frame of a sequence whose latents the model keeps, also when it is read again", () => {
  const { model, trainer } = train();
  const { startFrames } = coupledInfo(model);
  const [count = 0] = startFrames;
  assert.ok(count > 20, `${count}`);
  const latents = trainer.latents(0);
  for (const of of [model, vcgpdm.Model.fromJson(model.toJson())]) {
    const rollout = of.rollout({ frames: 4, sequence: 0, frame: 12 });
    assert.deepEqual([...rollout.latents(0).slice(0, 4)], [...latents.slice(24, 28)]);
  }
  assert.throws(() => model.rollout({ frames: 4, sequence: 0, frame: count }), {
    code: "rollout",
    message: `expected a frame of the sequence from 0 to ${count - 1} to start from, found ${count}`,
  });
});

it("goes on with a training that has used its iterations", () => {
  const { progress, trainer } = train();
  const before = progress.at(-1);
  assert.equal(before?.reason, "iterations");
  trainer.extend(8);
  let last = trainer.step();
  while (!last.done) last = trainer.step();
  assert.deepEqual([last.iteration, last.maxIterations, last.reason], [16, 16, "iterations"]);
  assert.ok(last.best > before.best, `${before.best} to ${last.best}`);
});

it("keeps the objective of weighted pose terms next to the bound", () => {
  const { model, progress } = train(1, { poseWeight: "balanced" });
  for (const { provenance } of [model, vcgpdm.Model.fromJson(model.toJson())].map(coupledInfo)) {
    assert.equal(provenance.settings.poseWeight, "balanced");
    assert.equal(provenance.objective, progress.at(-1)?.best);
    assert.ok(provenance.terms && provenance.bound !== provenance.objective);
    const { kinematics, dynamics, initial, entropy } = provenance.terms;
    const sum = [...kinematics, ...dynamics, initial, entropy].reduce((a, b) => a + b);
    assert.ok(Math.abs(provenance.bound - sum) < 1e-9 * Math.abs(sum), `${provenance.bound} and ${sum}`);
  }
  const plain = coupledInfo(train(1, { poseWeight: 1 }).model).provenance;
  assert.equal(plain.bound, plain.objective);
  assert.ok(!("poseWeight" in plain.settings));
  for (const poseWeight of [0, -1, Number.NaN, 1e9])
    assert.throws(() => train(1, { poseWeight }), {
      name: "VcgpdmError",
      code: "settings",
      message: `the weight of the pose terms must be a number from 0.001 to 1000, found ${poseWeight}`,
    });
  assert.throws(() => train(1, { poseWeight: /** @type {any} */ ("even") }), {
    code: "settings",
    message: /expected balanced, or a number from 0.001 to 1000/,
  });
});

it("trains parts that do not listen to each other", () => {
  const { alpha, provenance } = coupledInfo(train(1, { uncoupled: true }).model);
  assert.equal(provenance.settings.uncoupled, true);
  for (const between of [alpha[0]?.[1], alpha[1]?.[0]])
    assert.ok(Math.abs((between ?? 0) - 10) < 1e-9, `${alpha}`);
});

it("says which of several models is to be shown", () => {
  const best = (/** @type {number[]} */ ranks, /** @type {number[]} */ errors) =>
    vcgpdm.bestToShow(Uint8Array.from(ranks), Float64Array.from(errors));
  assert.deepEqual([best([1, 2, 2], [1, 3, 2]), best([1, 1], [5, 5]), best([], [])], [2, 0, -1]);
});

describe("the package", () => {
  it("loads with import and with require, at the version of its package.json", () => {
    const about = JSON.parse(readFileSync(at("crate/wasm/pkg/package.json"), "utf8"));
    assert.equal(vcgpdm.version(), about.version);
    assert.equal(installed.require("vcgpdm").version(), about.version);
    // A smaller build for a page's first visit.
    assert.ok(existsSync(installed.require.resolve("vcgpdm/player")));
  });

  it("reads what it writes", () => {
    const text = walkBvh();
    const first = read("walk.bvh", text);
    const again = read("again.bvh", first.toBvh());
    const { frames, frameTime, joints, figure, sha256 } = first.info();
    assert.equal(again.info().frames, frames);
    assert.equal(again.info().frameTime, frameTime);
    assert.deepEqual(again.info().joints, joints);
    assert.match(sha256, /^[0-9a-f]{64}$/);
    const [a, b] = [first.positions(), again.positions()];
    assert.equal(a.length, frames * figure.nodes.length * 3);
    assert.ok(finite(a));
    assert.deepEqual(b, a);
  });

  it("says in which line a file is wrong, and what was expected", () => {
    const lines = walkBvh().split("\n");
    const broken = lines.findIndex((line) => line.includes("CHANNELS"));
    lines[broken] = "CHANNELS three Zrotation Xrotation Yrotation";
    assert.throws(
      () => read("broken.bvh", lines.join("\n")),
      (error) =>
        error instanceof Error &&
        error.message.includes(String(broken + 1)) &&
        error.message.includes("three"),
    );
    assert.throws(() => read("empty.bvh", ""), Error);
  });

  it("refuses to train on two different skeletons", () => {
    const other =
      "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n" +
      "JOINT Head\n{\nOFFSET 0 5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n" +
      "MOTION\nFrames: 2\nFrame Time: 0.0333333\n0 9 0 0 0 0 0 0 0\n0 9 1 0 0 0 0 0 0\n";
    const clips = new vcgpdm.TrainingSet();
    clips.add(read("walk.bvh", walkBvh()));
    assert.throws(() => clips.add(read("other.bvh", other)), Error);
    assert.equal(clips.length, 1);
  });
});

describe("a trained model", () => {
  it("has a bound that rose, and stages that say where training is", () => {
    const { progress } = train();
    const [first, last] = [progress[0], progress.at(-1)];
    assert.ok(first && last);
    assert.ok(finite(progress.map(({ bound }) => bound)));
    assert.ok(last.best > first.bound, `${first.bound} to ${last.best}`);
    assert.equal(first.reason, null);
    assert.equal(last.reason, "iterations");
    assert.equal(last.fraction, 1);
  });

  it("is the same again for the same seed, and another for another", () => {
    const [a, b, c] = [train(7).model.toJson(), train(7).model.toJson(), train(8).model.toJson()];
    assert.equal(a, b);
    assert.notEqual(a, c);
  });

  it("rolls out, and does so again after it was saved and loaded", () => {
    const { model } = train();
    const loaded = vcgpdm.Model.fromJson(model.toJson());
    const options = { frames: 50, sequence: 0 };
    const [a, b] = [model.rollout(options), loaded.rollout(options)];
    assert.equal(a.frames, 50);
    assert.equal(a.latents(0).length, 50 * 2);
    assert.equal(a.positions().length, 50 * coupledInfo(model).figure.nodes.length * 3);
    assert.ok(finite(a.positions()));
    assert.deepEqual(b.latents(0), a.latents(0));
    assert.deepEqual(b.positions(), a.positions());
    assert.equal(read("rollout.bvh", a.toBvh()).info().frames, 50);
  });

  it("moves differently under other couplings, whose weights into a part sum to 1", () => {
    const { model } = train();
    const { alpha } = coupledInfo(model);
    const changed = alpha.map((row) => [...row]);
    const [row] = changed;
    assert.ok(row);
    row[1] = (row[1] ?? 1) * 100;
    for (const couplings of [alpha, changed]) {
      const weights = model.rollout({ frames: 3, sequence: 0, alpha: couplings }).weights();
      for (const target of couplings.keys()) {
        const sum = weights.reduce((total, row) => total + (row[target] ?? NaN), 0);
        assert.ok(Math.abs(sum - 1) < 1e-12, `weights into ${target} sum to ${sum}`);
      }
    }
    const options = { frames: 50, sequence: 0 };
    const learned = model.rollout(options).positions();
    assert.notDeepEqual(model.rollout({ ...options, alpha: changed }).positions(), learned);
    assert.notDeepEqual(
      model.rollout({ ...options, alpha: changed, reading: "re-inferred" }).positions(),
      learned,
    );
    assert.deepEqual(model.rollout({ ...options, alpha }).positions(), learned);
  });

  it("is refused with the path of the field when its file is wrong", () => {
    const { model } = train();
    const document = JSON.parse(model.toJson());
    assert.throws(() => vcgpdm.Model.fromJson("not JSON"), Error);
    assert.throws(() => vcgpdm.Model.fromJson("{}"), Error);
    const [key] = Object.keys(document).filter((key) => typeof document[key] === "object");
    assert.ok(key);
    assert.throws(
      () => vcgpdm.Model.fromJson(JSON.stringify({ ...document, [key]: 5 })),
      (error) => error instanceof Error && error.message.includes(key),
    );
  });
});
