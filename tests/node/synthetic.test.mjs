// The synthetic experiment from Node: made, trained step by step, and what it found at any time.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { seldom } from "../../scripts/node-tests.mjs";
import { builtPackage } from "../../scripts/package.mjs";

const vcgpdm = builtPackage();

/** Trains until the training ends, or for `iterations` iterations. */
function train(/** @type {import("vcgpdm").SyntheticExperiment} */ experiment, iterations = Infinity) {
  let progress = experiment.step();
  while (!progress.done && progress.iteration < iterations) progress = experiment.step();
  return progress;
}

describe("the synthetic experiment", () => {
  it("tells the truth about the data that it made, the same for the same seed", () => {
    const { frames, columns, latents, observed, drive, much, alike, largestAlpha } =
      new vcgpdm.SyntheticExperiment(3, true).truth();
    assert.deepEqual([frames, columns, drive, much, alike, largestAlpha], [300, 10, 0.1, 10, 4, 10]);
    assert.deepEqual(
      latents.map(({ length }) => length),
      [600, 600],
    );
    assert.deepEqual(
      observed.map(({ length }) => length),
      [3000, 3000],
    );
    assert.ok([...latents, ...observed].flat().every(Number.isFinite));
    assert.deepEqual(new vcgpdm.SyntheticExperiment(3, true).truth().latents, latents);
    const control = new vcgpdm.SyntheticExperiment(3, false).truth();
    assert.equal(control.drive, 0);
    assert.deepEqual(control.latents[0], latents[0], "the first part hears nobody");
    assert.notDeepEqual(control.latents[1], latents[1]);
  });

  it("finds who drives whom, and says what it knows at any time", () => {
    const experiment = new vcgpdm.SyntheticExperiment(0, true);
    train(experiment, 100);
    const early = experiment.findings();
    assert.ok(early.now.bound > early.start.bound, "the bound has risen");
    const { done, best } = train(experiment);
    assert.ok(done);
    const { alpha, weights, verdict, model, start, now } = experiment.findings();
    const { learned, explained, path, generated } = model;
    assert.deepEqual(start, early.start);
    assert.equal(now.bound, best);
    assert.ok(
      now.bound > early.now.bound && now.mse < start.mse / 2,
      JSON.stringify({ start, early: early.now, now }),
    );
    assert.ok(verdict.backIsRight && verdict.forthIsRight, JSON.stringify(verdict));
    const [[a11 = NaN, a12 = NaN] = [], [a21 = NaN, a22 = NaN] = []] = alpha;
    assert.deepEqual([verdict.back, verdict.forth], [a21 / a11, a12 / a22]);
    for (const target of [0, 1]) {
      const sum = weights.reduce((total, row) => total + (row[target] ?? NaN), 0);
      assert.ok(Math.abs(sum - 1) < 1e-12, `weights into ${target} sum to ${sum}`);
    }
    const { latents } = experiment.truth();
    for (const part of [0, 1]) {
      assert.ok((explained[part] ?? 0) > 0.95, `part ${part}: ${explained[part]} explained`);
      const off = (learned[part] ?? []).map((x, i) => (x - (latents[part]?.[i] ?? NaN)) ** 2);
      const mean = off.reduce((a, b) => a + b, 0) / off.length;
      assert.ok(mean < 0.02, `part ${part}: the learned latents lie ${Math.sqrt(mean)} from the true ones`);
      assert.deepEqual([path[part]?.length, generated[part]?.length], [600, 3000]);
    }
    const saved = experiment.model();
    const values = saved.rollout({ frames: 300 }).values();
    const own = [0, 1].flatMap((part) => generated[part]?.slice(-10) ?? []);
    values.slice(-20).forEach((value, i) => {
      assert.ok(Math.abs(value - (own[i] ?? NaN)) < 1e-9, "the model of the table makes the same curves");
    });
    assert.equal(vcgpdm.Model.fromJson(saved.toJson()).info().columns[10], "part 2 curve 1");
  });

  it("has as many inducing points as asked for", () => {
    const { poseIps, dynamicsIps } = new vcgpdm.SyntheticExperiment(0, true, 4).truth().start;
    assert.deepEqual([poseIps[1]?.length, dynamicsIps[1]?.length], [4 * 2, 4 * 4]);
    assert.throws(() => new vcgpdm.SyntheticExperiment(0, true, 0), /the number of .* inducing points/);
  });

  seldom.it("finds in the control that neither drives the other", () => {
    const experiment = new vcgpdm.SyntheticExperiment(0, false);
    train(experiment);
    const { verdict } = experiment.findings();
    assert.ok(verdict.back > 100 && verdict.forth > 100, JSON.stringify(verdict));
    assert.ok(verdict.backIsRight && verdict.forthIsRight);
  });
});
