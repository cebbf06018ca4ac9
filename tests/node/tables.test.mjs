// Models of tables: their couplings, weights and latents.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";

const vcgpdm = builtPackage();

const settings = {
  latent: 2,
  dynamicsIps: 6,
  poseIps: 6,
  order: 2,
  framesPerSecond: 30,
  seed: 1,
  maxIterations: 20,
};

it("couplings change the curves, and weights and latents are there", () => {
  const { Model, Table, Trainer, TrainingSet } = vcgpdm;
  const rows = Array.from({ length: 60 }, (_, t) => [Math.sin(t / 4), Math.cos(t / 4), Math.sin(t / 4 - 1)]);
  const table = Table.of("trial", ["x", "y", "follower"], new Float64Array(rows.flat()), 0.02);
  const without = table.without(["x"]);
  assert.deepEqual(without.info().columns, ["y", "follower"]);
  assert.equal(without.info().sha256, table.info().sha256);
  assert.equal(without.values().length, 2 * rows.length);
  assert.throws(() => table.without(["z"]), {
    code: "table",
    message: /expected some of the columns x, y, follower to leave out, found "z"/,
  });
  const parts = [
    { name: "machine", columns: ["x", "y"] },
    { name: "follower", columns: ["follower"] },
  ];
  const set = new TrainingSet();
  set.addTable(table);
  const trainer = new Trainer(set, { parts, ...settings });
  while (!trainer.step().done);
  assert.equal(trainer.latents(0).length, 60 * 2);
  assert.throws(() => trainer.latents(2), { name: "VcgpdmError" });

  const model = Model.fromJson(trainer.model().toJson());
  const { alpha } = model.info();
  assert.equal(alpha?.length, 2);
  const learned = model.rollout({ frames: 40 });
  const row = alpha?.[0];
  if (row) row[1] = (row[1] ?? 1) * 100;
  const changed = model.rollout({ frames: 40, alpha });
  assert.notDeepEqual(changed.values(), learned.values());
  const [before, after] = [learned.weights(), changed.weights()];
  assert.ok((after?.[0]?.[1] ?? 1) < (before?.[0]?.[1] ?? 0));
  for (const weights of [before, after])
    for (const target of [0, 1])
      assert.ok(Math.abs((weights?.[0]?.[target] ?? 0) + (weights?.[1]?.[target] ?? 0) - 1) < 1e-12);
  assert.equal(changed.latents(1).length, 40 * 2);
  const [one, two] = model.sampledRollouts({ frames: 40 }, 2, 7);
  assert.deepEqual(model.sampledRollouts({ frames: 40 }, 1, 8)[0]?.values(), two?.values());
  assert.notDeepEqual(one?.values(), two?.values());
});

it("a training says which columns never change and which clips are given twice", () => {
  const { Clip, Table, Trainer, TrainingSet } = vcgpdm;
  const rows = Array.from({ length: 20 }, (_, t) => [Math.sin(t / 3), 7]);
  const tables = new TrainingSet();
  tables.addTable(Table.of("trial", ["x", "y"], new Float64Array(rows.flat()), 0.02));
  const ofTable = new Trainer(tables, { parts: [{ name: "all", columns: ["x", "y"] }], ...settings });
  assert.deepEqual(ofTable.notices(), ["the column y never changes, so a model learns nothing about it"]);

  const clips = new TrainingSet();
  for (const _ of [1, 2]) clips.add(Clip.sample("walk-1"));
  const parts = Clip.sample("walk-1")
    .info()
    .presets.find(({ id }) => id === "lower-upper")?.parts;
  assert.ok(parts);
  const [notice = "", ...others] = new Trainer(clips, { parts, ...settings }).notices();
  assert.match(notice, /^the clip walk-1.* is given twice, so its frames count twice$/);
  assert.deepEqual(others, []);
});
