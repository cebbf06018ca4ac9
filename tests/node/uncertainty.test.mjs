// Predictions, sampled rollouts, moments and live rollouts of the package, on the model that walks first on
// the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { coupledInfo } from "./package.mjs";

const vcgpdm = builtPackage();
/** @type {import("vcgpdm").Model} */
let model;
before(async () => {
  model = vcgpdm.Model.fromJson(readFileSync(at("www/first/model.json"), "utf8"));
});

const close = (/** @type {number | undefined} */ a, /** @type {number | undefined} */ b, tolerance = 1e-9) =>
  assert.ok(Math.abs((a ?? Number.NaN) - (b ?? Number.NaN)) <= tolerance, `${a} and ${b}`);

describe("predictions", () => {
  it("of the product are what the weights make of the experts, and the step that the rollout takes", () => {
    const rollout = model.rollout({ frames: 40, sequence: 0 });
    const predicted = rollout.predictions();
    const { parts, alpha } = coupledInfo(model);
    const weights = rollout.weights();
    for (const [target, { latent }] of parts.entries()) {
      const path = rollout.latents(target);
      const means = predicted.means(target);
      assert.equal(means.length, (40 - predicted.firstFrame) * latent);
      for (let n = 0; n < means.length; n++) {
        const sum = parts.reduce((sum, _, source) => {
          const mean = predicted.expertMeans(source, target)[n] ?? Number.NaN;
          return sum + (weights[source]?.[target] ?? Number.NaN) * mean;
        }, 0);
        close(means[n], sum);
        close(means[n], path[n + predicted.firstFrame * latent], 1e-6);
      }
      for (const source of parts.keys())
        for (const variance of predicted.expertVariances(source, target))
          assert.ok(
            variance >= (alpha[source]?.[target] ?? 0) && variance <= (alpha[source]?.[target] ?? 0) + 1.001,
          );
    }
    assert.throws(() => predicted.means(7), /VcgpdmError|part/);
  });
});

describe("the model as it is sent to the page, with fewer digits", () => {
  for (const reading of /** @type {const} */ (["as-learned", "re-inferred"]))
    it(`is as sure as the one it was made of, ${reading}`, () => {
      const sent = vcgpdm.Model.fromJson(readFileSync(at("www/public/first/model.json"), "utf8"));
      const alpha = coupledInfo(model).alpha.map((row) => row.map((value) => value * 2));
      const [full, short] = [model, sent].map((model) =>
        model.rollout({ frames: 60, sequence: 0, alpha, reading }).predictions(),
      );
      for (const target of coupledInfo(model).parts.keys()) {
        const expected = full?.variances(target) ?? [];
        assert.ok(expected.length > 0);
        for (const [n, variance] of (short?.variances(target) ?? []).entries())
          close(Math.sqrt(variance / (expected[n] ?? Number.NaN)), 1, 0.06);
      }
      sent.free();
    });
});

describe("uncertain rollouts", () => {
  it("sampled follow from their seed, and spread as the moments say", () => {
    const options = { frames: 12, sequence: 0 };
    const [one, two] = model.sampledRollouts(options, 2, 7);
    const [again] = model.sampledRollouts(options, 1, 8);
    assert.deepEqual(two?.latents(0), again?.latents(0));
    assert.notDeepEqual(one?.latents(0), two?.latents(0));
    assert.ok(one && one.positions().length === model.rollout(options).positions().length);

    const moments = model.moments(options);
    const { latent } = coupledInfo(model).parts[0] ?? { latent: 0 };
    const draws = model.sampledRollouts(options, 400, 0).map((rollout) => rollout.latents(0));
    const at = 11 * latent;
    const mean = draws.reduce((sum, x) => sum + (x[at] ?? Number.NaN), 0) / draws.length;
    const deviation = Math.sqrt(moments.covariances(0)[11 * latent * latent] ?? Number.NaN);
    close(moments.means(0)[at], mean, 0.3 * deviation);
  });
});

describe("a live rollout", () => {
  const start = () => new vcgpdm.Endless(model.rollout({ frames: 100, sequence: 0 }), 89);

  it("goes on as the rollout does", () => {
    const rollout = model.rollout({ frames: 100, sequence: 0 });
    const next = start().advance(10);
    const { latent } = coupledInfo(model).parts[1] ?? { latent: 0 };
    const [path, live] = [rollout.latents(1), next.latents(1)];
    for (let n = 0; n < live.length; n++) close(live[n], path[90 * latent + n], 1e-6);
    assert.equal(next.positions().length, rollout.positions().length / 10);
    assert.equal(next.phases().length, 10 * coupledInfo(model).parts.length);
  });

  it("goes other ways when a coupling is cut, changed or a part is pushed, and refuses what does not fit", () => {
    const undisturbed = start().advance(5).latents(1);
    const cut = start();
    cut.cut(0, 1, true);
    assert.notDeepEqual(cut.advance(5).latents(1), undisturbed);
    const restored = start();
    restored.cut(0, 1, true);
    restored.cut(0, 1, false);
    assert.deepEqual(restored.advance(5).latents(1), undisturbed);
    const changed = start();
    const { alpha } = coupledInfo(model);
    const other = alpha.map((row, source) =>
      row.map((value, target) => (source === 0 && target === 1 ? 30 * value : value)),
    );
    changed.setCouplings(Float64Array.from(other.flat()), true);
    assert.notDeepEqual(changed.advance(5).latents(1), undisturbed);
    const pushed = start();
    const { latent } = coupledInfo(model).parts[1] ?? { latent: 0 };
    pushed.push(
      1,
      Float64Array.from({ length: latent }, () => 0.5),
    );
    assert.notDeepEqual(pushed.advance(5).latents(1), undisturbed);
    const pulled = start();
    pulled.pull(coupledInfo(model).figure.nodes.length - 1, 0, 0.05, 0);
    pulled.advance(1);

    const live = start();
    assert.throws(() => live.cut(0, 9, true), /expected a part from 0 to 1, found 9/);
    assert.throws(() => live.push(1, new Float64Array(latent + 1)), /expected a push of part 1/);
    assert.throws(() => live.setCouplings(Float64Array.from([1, 2, 3]), false), /coupling variance/);
    live.cut(0, 1, true);
    assert.throws(() => live.cut(1, 1, true), /expected one coupling into part 1 that is not cut/);
    assert.throws(() => live.pull(9999, 0, 0, 0), /expected a node of the figure/);
    // What was refused has changed nothing: the first cut still acts.
    assert.deepEqual(
      live.advance(5).latents(1),
      (() => {
        const same = start();
        same.cut(0, 1, true);
        return same.advance(5).latents(1);
      })(),
    );
  });
});

it("says how sure the model is at points of a latent space, and where its dynamics lead from there", () => {
  const { Model } = vcgpdm;
  const rollout = model.rollout({ frames: 40 });
  const { order, parts } = coupledInfo(model);
  const width = parts[0]?.latent ?? 0;
  const path = rollout.latents(0);
  const rows = Array.from({ length: 40 }, (_, t) => [...path.subarray(t * width, (t + 1) * width)]);
  const { poseVariance, dynamicsVariance, steps } = rollout.latentField(0, rows);
  for (let t = order; t < 39; t++)
    for (let q = 0; q < width; q++)
      assert.ok(
        Math.abs((steps[t]?.[q] ?? NaN) - ((rows[t + 1]?.[q] ?? 0) - (rows[t]?.[q] ?? 0))) < 1e-6,
        `the step of frame ${t}`,
      );
  const far = rollout.latentField(0, [rows[9]?.map((x) => x + 1000) ?? []]);
  assert.ok(Math.max(...poseVariance) < 0.5 && Math.abs((far.poseVariance[0] ?? 0) - 1) < 1e-9);
  assert.ok((far.dynamicsVariance[0] ?? 0) > (dynamicsVariance[9] ?? 1));
  assert.throws(() => rollout.latentField(0, [[0]]), { name: "VcgpdmError" });
  assert.throws(() => Model.fromJson(model.toJson()).rollout({ frames: 5 }).latentField(9, []), {
    name: "VcgpdmError",
  });
});
