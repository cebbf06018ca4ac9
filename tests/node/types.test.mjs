// The declared types of objects that are put together from several structs, or whose fields state a type of their
// own. All other types are those of the Rust structs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";

const vcgpdm = builtPackage();

/** The names of the fields of a declared type, sorted. */
function declared(/** @type {string} */ name) {
  const types = readFileSync(at("crate/wasm/pkg/web/glue.d.ts"), "utf8");
  const [, fields = ""] = new RegExp(`^export type ${name} = \\{\n(.*?)^\\};`, "ms").exec(types) ?? [];
  return [...fields.matchAll(/^ {2}(\w+)\??: /gm)].map(([, field]) => field).sort();
}
const check = (/** @type {string} */ name, /** @type {object | undefined} */ value) => {
  assert.ok(value, name);
  assert.deepEqual(Object.keys(value).sort(), declared(name), name);
};
const document = (/** @type {string} */ name) =>
  readFileSync(at("crate/vcgpdm/tests/library/documents", name), "utf8");

/** Four short walks of a body in two parts. */
function walks() {
  const { Clip, TrainingSet } = vcgpdm;
  const clips = new TrainingSet();
  for (const id of ["walk-1", "walk-2", "walk-3", "walk-4"]) clips.add(Clip.sample(id).cut(0, 50));
  return clips;
}

describe("the declared types", () => {
  it("are what the functions give", () => {
    const { Clip, Library, Results, Study, Trainer } = vcgpdm;
    const clip = Clip.sample("walk-1").cut(0, 50);
    check("ClipInfo", clip.info());
    check("ClipState", clip.state());
    const parts = clip.info().presets.find(({ id }) => id === "lower-upper")?.parts ?? [];
    const size = { latent: 2, dynamicsIps: 4, poseIps: 4, order: 2, maxIterations: 16 };
    const settings = {
      ...{ ...size, parts, framesPerSecond: 15, seed: 1, ownRollouts: true },
      poseWeight: /** @type {const} */ ("balanced"),
    };
    const trainer = new Trainer(walks(), settings);
    const phases = new Set();
    for (let done = false; !done; ) {
      const progress = trainer.step();
      check("TrainingProgress", progress);
      phases.add(progress.phase);
      done = progress.done;
    }
    assert.deepEqual([...phases], ["couplings-kernels-inducing-points", "everything", "own-rollouts"]);
    const model = trainer.model();
    check("ModelInfo", model.info());
    check("ModelProvenance", model.info().provenance);
    assert.deepEqual(model.info().provenance.settings, settings);
    const rollout = model.rollout({ frames: 60, sequence: 0 });
    const measures = rollout.measures(15);
    check("Measures", measures);
    assert.deepEqual([measures.limbs.length, measures.parts.length], [4, 2]);
    check("LatentField", rollout.latentField(0, [[0, 0]]));
    const observed = { given: [parts[0]?.name ?? ""], until: 1 };
    check("PartCompletion", model.complete(Clip.sample("walk-3"), observed).scores()[0]);
    const { rollout: own, training, difference } = rollout.latentLogDensity();
    assert.ok(own !== null && training !== null && difference !== null);
    assert.ok(Math.abs(difference - (own - training)) < 1e-9);
    const alpha = [
      [1, 50],
      [50, 0.001],
    ];
    const other = model.rollout({ frames: 60, alpha }).latentLogDensity();
    assert.ok((other.rollout ?? 0) < own, "the motion is less likely");
    assert.equal(other.training, training);

    const results = Results.empty(walks(), { parts, framesPerSecond: 15 });
    const [trial] = results.setting().trials;
    check("Trial", trial);
    const plan = { models: [/** @type {const} */ ("tmp")], heldOut: [3] };
    const [planned] = results.jobs(plan);
    check("PlannedJob", planned);
    const score = { dtwMse: 1, mse: 1, variance: 1 };
    const numbers = { objective: 0, iterations: 1, seconds: 1, frames: 9, storedNumbers: 1 };
    results.add(planned?.job ?? {}, { score, bound: null, reason: null, ...numbers });
    check("FinishedJob", results.finished()[0]);
    check("LibraryInfo", Library.fromJson(document("library.json")).info());
    const study = Study.fromJson(readFileSync(at("www/public/study/walks.study.json"), "utf8"));
    check("StudyInfo", study.info);
    for (const stimulus of study.info.stimuli) check("StudyStimulus", stimulus);
  });

  it("hold for models of every kind", () => {
    const { Model } = vcgpdm;
    for (const kind of ["vcgpdm", "map-cgpdm", "tmp", "dmp-rhythmic", "series", "combination"]) {
      const text = document(`${kind}.json`);
      const any = Model.fromJson(text);
      check("ModelInfo", any.info());
      assert.equal(any.toJson(), text);
      const rolled = any.rollout({ frames: 7 });
      const alpha = Array(2).fill([1, 9]);
      if (kind === "map-cgpdm")
        assert.notDeepEqual(any.rollout({ frames: 7, alpha }).values(), rolled.values());
      assert.equal(rolled.values().length, 7 * any.info().columns.length, kind);
      assert.equal(rolled.toCsv().split("\n").length, 9);
      assert.equal(any.info().alpha !== null, ["vcgpdm", "series", "combination"].includes(kind), kind);
      if (kind !== "series") assert.equal(rolled.toClip().info().frames, 7);
    }
  });
});
