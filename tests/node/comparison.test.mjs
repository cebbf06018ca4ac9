// Models compared with the npm package, as a developer would from Node.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";

const vcgpdm = builtPackage();

/** Three short walks and how they are compared. */
function trials() {
  const { Clip, TrainingSet } = vcgpdm;
  const clips = new TrainingSet();
  const walks = ["walk-1", "walk-2", "walk-3"].map((id) => Clip.sample(id));
  for (const walk of walks) clips.add(walk);
  const parts = walks[0]?.info().presets.find(({ id }) => id === "lower-upper")?.parts ?? [];
  return { clips, common: { parts, framesPerSecond: 15 } };
}

/** @type {import("vcgpdm").Candidate[]} */
const CANDIDATES = [
  { model: "vcgpdm", latent: 2, order: 2, dynamicsIps: 5, poseIps: 5, maxIterations: 8 },
  { model: "vgpdm", latent: 2, order: 2, dynamicsIps: 5, poseIps: 5, maxIterations: 8 },
  { model: "map-gpdm", latent: 2, order: 2, maxIterations: 3, balanced: false },
  { model: "map-cgpdm", latent: 2, order: 2, maxIterations: 3, balanced: true },
  { model: "tmp", primitives: 4 },
  { model: "dmp-discrete", bases: 15 },
  { model: "dmp-rhythmic", bases: 15 },
];

/** @type {import("vcgpdm").Plan} */
const PLAN = {
  models: ["vcgpdm", "vgpdm", "dmp-rhythmic"],
  latent: 2,
  order: 2,
  maxIterations: 8,
  ips: [4, 5],
  primitives: [null],
  bases: [10],
  balanced: false,
  heldOut: [],
  seeds: [1, 2],
  trainingTrials: [],
  growth: true,
};

describe("comparing models from Node", () => {
  it("trains every kind of model, predicts the trial held out and says what was found", () => {
    const { Evaluation, Fold, Model, Results, version } = vcgpdm;
    const { clips, common } = trials();
    const results = Results.empty(clips, common);
    assert.equal(results.setting().trials.length, 3);
    const fold = new Fold(clips, common, { heldOut: 1 });
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
      // From the last sequence, its first frames, the model of the file makes the same movement.
      const model = Model.fromJson(training.model().toJson());
      const { kind, sequences } = model.info();
      assert.deepEqual([kind, sequences.length], [candidate.model, 3]);
      const again = model.rollout({ frames: fold.frames, sequence: 2 }).positions();
      assert.deepEqual(again, predicted, candidate.model);
      const outcome = prediction.outcome(0.5);
      assert.ok(outcome.score.dtwMse > 0 && outcome.storedNumbers > 0, candidate.model);
      assert.equal(
        outcome.bound === null,
        candidate.model.startsWith("map") || candidate.model.startsWith("dmp"),
        candidate.model,
      );
      results.add({ candidate, heldOut: 1, trainingTrials: 2, seed: 1 }, outcome);
    }
    const finished = results.finished();
    assert.deepEqual(
      finished.map(({ job }) => job.candidate),
      CANDIDATES,
    );
    assert.ok(finished.every(({ engine, failure }) => engine === `vcgpdm ${version()}` && failure === null));
    const found = results.comparison();
    assert.deepEqual(
      found.models.map(({ model }) => model),
      CANDIDATES.map(({ model }) => model),
    );
    assert.ok(found.models.every(({ mse, seconds }) => mse.standardError === null && seconds.mean === 0.5));
    // As a file, with the names of the terminal program, and back: the same.
    const text = results.toJson();
    assert.equal(JSON.parse(text).finished[0].job.candidate.dynamics_ips, 5);
    const again = Results.fromJson(text);
    assert.deepEqual(again.comparison(), found);
    assert.equal(again.toJson(), text);
  });

  it("plans the jobs that are asked for, and knows which are done", () => {
    const { Evaluation, Fold, Results } = vcgpdm;
    const { clips, common } = trials();
    const results = Results.empty(clips, common);
    const jobs = results.jobs(PLAN);
    // In each of three folds: two vGPDMs with two seeds, one DMP, which has none; and the vCGPDM with both,
    // and growth.
    assert.equal(jobs.length, 3 * (2 * 2 + 2 * 2 + 1) + 1);
    assert.equal(new Set(jobs.map(({ id }) => id)).size, jobs.length);
    assert.ok(jobs.every(({ done }) => !done));
    const dmp = jobs.find(({ job }) => job.candidate.model === "dmp-rhythmic");
    assert.ok(dmp);
    assert.equal(dmp.id, "dmp-rhythmic, 10 bases; trial 1 held out, 2 trained on, seed 0");
    const { candidate, heldOut, trainingTrials, seed } = dmp.job;
    const evaluation = new Evaluation(new Fold(clips, common, { heldOut, trainingTrials }), candidate, seed);
    while (!evaluation.step().done);
    results.add(dmp.job, evaluation.prediction().outcome(1));
    const done = results.jobs(PLAN).filter(({ done }) => done);
    assert.deepEqual(done, [{ ...dmp, done: true }]);
    assert.deepEqual(
      results.finished().map(({ id }) => id),
      [dmp.id],
    );
    // A body in one part has nothing to couple.
    const whole = {
      parts: [{ name: "body", joints: common.parts.flatMap(({ joints }) => joints) }],
      framesPerSecond: 15,
    };
    const uncoupled = Results.empty(clips, whole).jobs(PLAN);
    assert.equal(uncoupled.length, 3 * (2 * 2 + 1));
    assert.ok(uncoupled.every(({ job }) => job.candidate.model !== "vcgpdm"));
  });

  it("counts trials from 0 in folds, jobs and plans, and from 1 in a file", () => {
    const { Evaluation, Fold, Results } = vcgpdm;
    const { clips, common } = trials();
    const results = Results.empty(clips, common);
    const planned = results.jobs({ ...PLAN, models: ["dmp-rhythmic"], heldOut: [2, 0] });
    assert.deepEqual(
      planned.map(({ job }) => job.heldOut),
      [2, 0],
    );
    for (const { job } of planned) {
      const { candidate, heldOut, seed } = job;
      const fold = new Fold(clips, common, { heldOut });
      const evaluation = new Evaluation(fold, candidate, seed);
      while (!evaluation.step().done);
      results.add(job, evaluation.prediction().outcome(1));
    }
    assert.deepEqual(
      results.finished().map(({ job }) => job.heldOut),
      [2, 0],
    );
    const text = results.toJson();
    assert.deepEqual(
      JSON.parse(text).finished.map((/** @type {any} */ { job }) => job.held_out),
      [3, 1],
    );
    assert.equal(Results.fromJson(text).toJson(), text);
    // The page appends results to the text of a file.
    const { finished, ...others } = JSON.parse(text);
    assert.equal(JSON.stringify({ ...others, finished }), text);
  });

  it("merges what was computed elsewhere, and keeps what it knows", () => {
    const { Results } = vcgpdm;
    const { clips, common } = trials();
    const outcome = {
      score: { dtwMse: 0.1, mse: 0.2, variance: 1 },
      bound: null,
      objective: -1,
      iterations: 1,
      seconds: 1,
      frames: 10,
      storedNumbers: 10,
      reason: null,
    };
    const [here, there] = [Results.empty(clips, common), Results.empty(clips, common)];
    const job = (/** @type {number} */ heldOut) => ({
      candidate: /** @type {const} */ ({ model: "dmp-discrete", bases: 5 }),
      heldOut,
      trainingTrials: 2,
      seed: 0,
    });
    here.add(job(0), outcome);
    there.add(job(0), { ...outcome, seconds: 9 });
    there.add(job(1), outcome);
    here.merge(there);
    assert.deepEqual(
      here.finished().map(({ job, outcome }) => [job.heldOut, outcome?.seconds]),
      [
        [0, 1],
        [1, 1],
      ],
    );
    const slower = Results.empty(clips, { ...common, framesPerSecond: 10 });
    assert.throws(
      () => here.merge(slower),
      /these results are of another frame rate: expected 15 .*, found 10/,
    );
    assert.throws(() => here.add(job(3), outcome), /`heldOut`: expected a trial from 0 to 2, found 3/);
    assert.throws(() => here.add(job(2), { ...outcome, seconds: -1 }), /expected a time from 0 to 1e100/);
  });

  it("refuses in words what cannot be compared", () => {
    const { Clip, Evaluation, Fold, Results, TrainingSet } = vcgpdm;
    const { clips, common } = trials();
    assert.throws(
      () => new Fold(clips, common, { heldOut: 3 }),
      /^VcgpdmError: `heldOut`: expected a trial from 0 to 2, found 3/,
    );
    assert.throws(
      () => new Fold(clips, common, { heldOut: 0, trainingTrials: 3 }),
      /expected from 1 to 2 trials to train on, found 3/,
    );
    const text = JSON.stringify({ ...JSON.parse(Results.empty(clips, common).toJson()), version: 9 });
    assert.throws(
      () => Results.fromJson(text),
      /vcgpdm-evaluation version 1\), found "vcgpdm-evaluation" version 9/,
    );
    assert.throws(
      () => Results.empty(clips, { ...common, framesPerSecond: NaN }),
      /expected a positive number of frames a second, found NaN/,
    );
    assert.throws(
      () => Results.empty(clips, common).jobs({ ...PLAN, heldOut: [0, 3] }),
      /`heldOut`: expected a trial from 0 to 2, found 3/,
    );
    const twice = new TrainingSet();
    twice.add(Clip.sample("walk-1"));
    twice.add(Clip.sample("walk-1"));
    assert.throws(() => Results.empty(twice, common), /trials 1 and 2 are the same motion/);
    const one = new TrainingSet();
    one.add(Clip.sample("walk-1"));
    one.add(Clip.sample("walk-2").cut(0, 2));
    assert.throws(
      () => new Evaluation(new Fold(one, common, { heldOut: 0 }), /** @type {any} */ (CANDIDATES[0]), 0),
      /Walk, trial 2|walk-2/,
    );
  });
});
