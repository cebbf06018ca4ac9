// Rollouts that start with frames of a clip that was never trained on.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { coupledInfo } from "./package.mjs";

it("a rollout starts with the first frames of a clip that was not trained on", async () => {
  const { Clip, Endless, Table, TrainingSet, Trainer, train } = builtPackage();
  const clips = [Clip.sample("walk-1"), Clip.sample("walk-2")];
  const model = await train(clips, { parts: "lower,upper", framesPerSecond: 15, maxIterations: 60 });
  const { parts, alpha, figure } = coupledInfo(model);
  const walk = Clip.sample("walk-5");

  const start = model.infer(walk, 8);
  assert.deepEqual(
    start.map((frames) => [frames.length, frames[0]?.length]),
    parts.map(({ latent }) => [8, latent]),
  );
  const path = (/** @type {import("vcgpdm").Rollout} */ rollout, part = 0, frames = 8) =>
    [...rollout.latents(part)].slice(0, frames * (parts[part]?.latent ?? 0));
  const rollout = model.rollout({ start, frames: 60 });
  assert.equal(rollout.frames, 60);
  for (const part of [0, 1]) assert.deepEqual(path(rollout, part), start[part]?.flat());
  assert.notDeepEqual(path(rollout), path(model.rollout({ frames: 60 })));

  // The poses of the first frames are nearly those of the clip; the body travels on its own way.
  const nodes = figure.nodes.length;
  const recorded = walk.resample(15).positions();
  const pose = (/** @type {Float32Array} */ positions, /** @type {number} */ frame) => {
    const places = [...positions.subarray(3 * nodes * frame, 3 * nodes * (frame + 1))];
    return places.map((place, k) => place - (places[k % 3] ?? 0));
  };
  const apart = (/** @type {Float32Array} */ positions) => {
    const heights = pose(positions, 7).filter((_, k) => k % 3 === 1);
    const expected = pose(recorded, 7).filter((_, k) => k % 3 === 1);
    return Math.sqrt(heights.reduce((sum, y, k) => sum + (y - (expected[k] ?? 0)) ** 2, 0) / nodes);
  };
  assert.ok(apart(rollout.positions()) < 0.03, `${apart(rollout.positions())} m`);

  // Couplings act after the start; sampled and live rollouts, moments and predictions go on from it.
  const stronger = alpha.map((row, source) =>
    row.map((value, target) => (source === target ? value : value / 20)),
  );
  const changed = model.rollout({ start, frames: 60, alpha: stronger, reading: "re-inferred" });
  assert.deepEqual(path(changed), path(rollout));
  assert.notDeepEqual(path(changed, 1, 30), path(rollout, 1, 30));
  for (const sampled of model.sampledRollouts({ start, frames: 20 }, 2, 1)) {
    assert.deepEqual(path(sampled), path(rollout));
    assert.notDeepEqual(path(sampled, 0, 12), path(rollout, 0, 12));
  }
  const moments = model.moments({ start, frames: 12 });
  assert.deepEqual([...moments.means(0)].slice(0, path(rollout).length), path(rollout));
  assert.ok((moments.covariances(0).at(-1) ?? 0) > 0);
  assert.ok(rollout.predictions().means(0).every(Number.isFinite));
  const live = new Endless(rollout, 59).advance(5);
  assert.equal(live.positions().length, 5 * nodes * 3);
  assert.ok(live.latents(0).every(Number.isFinite));
  assert.equal(typeof rollout.health().state, "string");

  const refused = (/** @type {unknown} */ options, /** @type {object} */ reason) =>
    assert.throws(() => model.rollout(/** @type {any} */ (options)), { name: "VcgpdmError", ...reason });
  refused(
    { start, sequence: 1 },
    { code: "rollout", message: /or a training sequence and its frame, found/ },
  );
  refused({ start, frame: 3 }, { message: /found both: sequence 0 and frame 3$/ });
  refused(
    { start: start.slice(1) },
    { code: "rollout", message: "expected start latents of 2 parts, found 1" },
  );
  refused(
    { start: start.map((frames) => frames.slice(0, 1)) },
    { message: /start latents of part 0 must be \d+ x \d+ numbers, found 1 x/ },
  );
  refused(
    { start: [[[1, 2], [3]], []] },
    { message: /matrix 0: expected rows of 2 numbers, found 1 in row 1/ },
  );
  assert.throws(() => model.infer(walk, 1), { code: "clip", message: /walk.*at least \d+ frames/ });
  assert.throws(() => model.infer(walk, 99999), {
    code: "clip",
    message: /expected 99999 frames or more to start from, found \d+ frames at the frame rate of the model/,
  });
  const other = Clip.read("other.bvh", walk.toBvh().replaceAll("Head", "Skull"));
  assert.throws(() => model.infer(other, 8), { name: "VcgpdmError", code: "clips" });

  // A model of tables has no clip.
  const tables = new TrainingSet();
  const rows = Array.from({ length: 60 }, (_, t) => [Math.sin(t / 4), Math.cos(t / 4)]);
  tables.addTable(Table.of("trial", ["x", "y"], new Float64Array(rows.flat()), 0.02));
  const columns = [{ name: "all", columns: ["x", "y"] }];
  const settings = { latent: 2, dynamicsIps: 5, poseIps: 5, order: 2, framesPerSecond: 50, seed: 1 };
  const trainer = new Trainer(tables, { ...settings, parts: columns, maxIterations: 2 });
  while (!trainer.step().done);
  assert.throws(() => trainer.model().infer(walk, 8), { code: "model", message: /a model of a body/ });
});
