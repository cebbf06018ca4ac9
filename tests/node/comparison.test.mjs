// Models compared with the npm package, as a developer would from Node.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, describe, it } from "node:test";
import { installPackage } from "./package.mjs";

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
before(async () => {
  installed = await installPackage();
});
after(() => installed?.remove());

/** Three short walks and how they are compared. */
function trials() {
  const { Clip, TrainingSet } = installed.vcgpdm;
  const clips = new TrainingSet();
  const walks = ["walk-1", "walk-2", "walk-3"].map((id) => Clip.sample(id));
  for (const walk of walks) clips.add(walk);
  const { parts } = /** @type {any} */ (walks[0]?.info().presets.find(({ id }) => id === "lower-upper"));
  return { clips, common: { parts, framesPerSecond: 15 } };
}

/** @type {import("vcgpdm").Candidate[]} */
const CANDIDATES = [
  { model: "vcgpdm", latent: 2, order: 2, dynamics_ips: 5, pose_ips: 5, max_iterations: 8 },
  { model: "vgpdm", latent: 2, order: 2, dynamics_ips: 5, pose_ips: 5, max_iterations: 8 },
  { model: "map-gpdm", latent: 2, order: 2, max_iterations: 3, balanced: false },
  { model: "map-cgpdm", latent: 2, order: 2, max_iterations: 3, balanced: true },
  { model: "tmp", primitives: 4 },
  { model: "dmp-discrete", bases: 15 },
  { model: "dmp-rhythmic", bases: 15 },
];

describe("comparing models from Node", () => {
  it("trains every kind of model, predicts the trial held out and says what was found", () => {
    const { compare, emptyResults, Evaluation, Fold, version } = installed.vcgpdm;
    const { clips, common } = trials();
    const results = emptyResults(clips, common);
    assert.equal(results.setting.trials.length, 3);
    const fold = new Fold(clips, common, 2, 2);
    const actual = fold.actual();
    assert.ok(fold.frames > 20 && actual.length % fold.frames === 0);
    assert.ok(Math.abs(fold.frameTime - 1 / 15) < 0.01);
    for (const candidate of CANDIDATES) {
      const training = new Evaluation(fold, candidate, 1);
      let progress;
      do progress = training.step();
      while (!progress.done);
      assert.equal(progress.fraction, 1, candidate.model);
      const prediction = training.prediction();
      const predicted = prediction.positions();
      assert.equal(predicted.length, actual.length);
      assert.ok(predicted.every(Number.isFinite), candidate.model);
      const outcome = prediction.outcome(0.5);
      assert.ok(outcome.score.dtw_mse > 0 && outcome.stored_numbers > 0, candidate.model);
      assert.equal(
        outcome.bound === null,
        candidate.model.startsWith("map") || candidate.model.startsWith("dmp"),
        candidate.model,
      );
      const job = { candidate, held_out: 2, training_trials: 2, seed: 1 };
      results.finished.push({ job, engine: `vcgpdm ${version()}`, outcome, failure: null });
    }
    const found = compare(results);
    assert.deepEqual(
      found.models.map(({ model }) => model),
      CANDIDATES.map(({ model }) => model),
    );
    assert.ok(found.models.every(({ mse, seconds }) => mse.standardError === null && seconds.mean === 0.5));
    // As a file and back: the same.
    assert.deepEqual(compare(JSON.parse(JSON.stringify(results))), found);
  });

  it("refuses in words what cannot be compared", () => {
    const { Clip, compare, emptyResults, Evaluation, Fold, TrainingSet } = installed.vcgpdm;
    const { clips, common } = trials();
    assert.throws(() => new Fold(clips, common, 4, 2), /expected a trial from 1 to 3 to hold out/);
    assert.throws(() => new Fold(clips, common, 0, 2), /expected a trial from 1, found 0/);
    assert.throws(() => compare(/** @type {any} */ ({})), /expected the results of an evaluation: .*format/);
    const other = { ...emptyResults(clips, common), version: 9 };
    assert.throws(() => compare(other), /expected vcgpdm-evaluation version 1, found "vcgpdm-evaluation" version 9/);
    const fold = new Fold(clips, common, 1, 1);
    assert.throws(
      () => new Evaluation(fold, /** @type {any} */ ({ model: "gplvm" }), 0),
      /candidate: unknown variant `gplvm`/,
    );
    assert.throws(() => new Fold(clips, common, 1, 3), /expected from 1 to 2 trials to train on, found 3/);
    assert.throws(
      () => emptyResults(clips, { ...common, framesPerSecond: NaN }),
      /expected a positive number of frames a second, found NaN/,
    );
    const twice = new TrainingSet();
    twice.add(Clip.sample("walk-1"));
    twice.add(Clip.sample("walk-1"));
    assert.throws(() => emptyResults(twice, common), /trials 1 and 2 are the same motion/);
    const one = new TrainingSet();
    one.add(Clip.sample("walk-1"));
    one.add(Clip.sample("walk-2").cut(0, 2));
    assert.throws(
      () => new Evaluation(new Fold(one, common, 1, 1), /** @type {any} */ (CANDIDATES[0]), 0),
      /Walk, trial 2|walk-2/,
    );
  });

  it("comes in a smaller build for a page's first visit", () => {
    assert.ok(existsSync(installed.require.resolve("vcgpdm/playground")));
  });
});
