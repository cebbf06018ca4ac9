// One half of a walk that was not trained on, inferred from the other half.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";

it("a model observes the legs of a clip, infers the arms, and goes on by itself from a time on", async () => {
  const { Clip, train } = builtPackage();
  const clips = [Clip.sample("walk-1"), Clip.sample("walk-2")];
  const model = await train(clips, { parts: "lower,upper", framesPerSecond: 15, maxIterations: 100 });
  const walk = Clip.sample("walk-3");

  const whole = model.complete(walk, { given: ["lower"] });
  const [upper] = whole.scores();
  assert.equal(upper?.part, "upper");
  assert.ok(upper.mse > 0 && upper.mse < 0.9 * upper.mseMeanPose);
  assert.ok(upper.coverage95 > 0.5 && upper.coverage95 <= 1);
  assert.equal(upper.afterCut, undefined);
  const nodes = model.info().figure?.nodes.length ?? 0;
  assert.equal(whole.positions().length, whole.frames * nodes * 3);
  assert.equal(whole.recorded().length, whole.frames * nodes * 3);
  assert.ok(whole.latents(1).every(Number.isFinite));

  const cut = model.complete(walk, { given: ["lower"], until: 1 });
  const [after] = cut.scores();
  assert.ok((after?.afterCut?.mse ?? 0) > 0);
  // The legs are as recorded for a second, and the model's own from then on.
  const legs = (/** @type {Float32Array} */ positions, /** @type {number} */ frame) =>
    positions.subarray(frame * nodes * 3, (frame + 1) * nodes * 3);
  assert.notDeepEqual(legs(cut.positions(), cut.frames - 1), legs(whole.positions(), cut.frames - 1));

  const refused = (/** @type {unknown} */ options) => () =>
    model.complete(walk, /** @type {any} */ (options));
  assert.throws(refused({ given: ["arms"] }), {
    name: "VcgpdmError",
    message: /expected parts of lower, upper, found arms/,
  });
  assert.throws(refused({ given: ["lower", "upper"] }), {
    code: "rollout",
    message: /from 1 to 1 of the parts/,
  });
  assert.throws(refused({ given: ["lower"], until: 60 }), {
    code: "rollout",
    message: /^complete: `until`: expected from 0\.\d+ to \d+\.\d+ seconds, found 60$/,
  });
  assert.throws(refused({ given: ["lower"], alpha: [[1]] }), { code: "rollout" });
});
