// Every option has a default, and parts are taken by preset or by names wherever parts are taken.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";

const vcgpdm = builtPackage();

/** Two short walks. */
function walks() {
  const { Clip, TrainingSet } = vcgpdm;
  const clips = new TrainingSet();
  for (const id of ["walk-1", "walk-2"]) clips.add(Clip.sample(id).cut(0, 90));
  return clips;
}

it("a comparison needs clips alone, and takes parts as a training does", () => {
  const { Evaluation, Fold, Results } = vcgpdm;
  const clips = walks();
  const setting = Results.empty(clips).setting();
  assert.equal(setting.framesPerSecond, 30);
  assert.deepEqual(
    setting.parts.map(({ name }) => name),
    ["lower", "upper"],
  );
  const byNames = setting.parts.map(({ name, joints }) => ({ name, joints: [...joints] }));
  for (const parts of ["lower,upper", "lower-upper", byNames])
    assert.deepEqual(Results.empty(clips, { parts }).setting(), setting);

  const results = Results.empty(clips, { framesPerSecond: 15 });
  const fold = new Fold(clips, { framesPerSecond: 15 });
  assert.equal(fold.actual().length > 0, true);
  const few = { dynamicsIps: 3, poseIps: 3, maxIterations: 1 };
  const evaluation = new Evaluation(fold, few);
  while (!evaluation.step().done);
  results.add({ candidate: few }, evaluation.prediction().outcome(1));
  const [finished] = results.finished();
  assert.deepEqual(finished?.job, {
    candidate: { model: "vcgpdm", latent: 3, order: 2, dynamicsIps: 3, poseIps: 3, maxIterations: 1 },
    heldOut: 0,
    trainingTrials: 1,
    seed: 0,
  });
  const planned = results.jobs();
  assert.deepEqual(new Set(planned.map(({ job }) => job.candidate.model)).size, 7);
  assert.deepEqual(new Set(planned.map(({ job }) => job.heldOut)), new Set([0, 1]));
  const rhythmic = results.jobs({ models: ["dmp-rhythmic"] });
  assert.deepEqual(
    rhythmic.map(({ job }) => job.candidate),
    [0, 1].map(() => ({ model: "dmp-rhythmic", bases: 20 })),
  );
  // Without a model, one part is learned by the model of one part.
  const whole = new Evaluation(new Fold(clips, { parts: "whole", framesPerSecond: 15 }), few);
  while (!whole.step().done);
  assert.ok(whole.prediction().outcome(1).score.mse > 0);
});

it("rollouts, costs and tables need no options", async () => {
  const { Clip, Table, train, trainingCost } = vcgpdm;
  const short = { latent: 1, dynamicsIps: 3, poseIps: 3, order: 1, framesPerSecond: 15, maxIterations: 1 };
  const model = await train(Clip.sample("walk-1").cut(0, 60), short);
  const sampled = model.sampledRollouts();
  assert.deepEqual([sampled.length, sampled[0]?.frames], [10, 300]);
  assert.deepEqual(model.sampledRollouts({ frames: 9 }, 1)[0]?.values(), sampledFirst(model));
  assert.equal(model.moments().means(0).length, 300);
  const usual = { latent: 3, order: 2, dynamicsIps: 12, poseIps: 12, maxIterations: 250 };
  assert.deepEqual(trainingCost({}, 100, [30, 33]), trainingCost(usual, 100, [30, 33]));

  const values = Array.from({ length: 120 }, (_, at) => Math.sin(at / 7));
  const table = Table.of("waves", ["a", "b"], /** @type {any} */ (values));
  assert.equal(table.info().frameTime, null);
  const waves = await train(table, { latent: 1, maxIterations: 1 });
  assert.ok(Math.abs(waves.info().frameTime - 1 / 30) < 1e-12);
});

const sampledFirst = (/** @type {import("vcgpdm").Model} */ model) =>
  model.sampledRollouts({ frames: 9 }, 1, 0)[0]?.values();

it("the plan of a library names the shared parts, or shares none", () => {
  const { LibraryTrainer } = vcgpdm;
  const settings = {
    latent: 1,
    dynamicsIps: 3,
    poseIps: 3,
    order: 1,
    framesPerSecond: 15,
    maxIterations: 1,
  };
  const movements = [{ name: "one" }, { name: "two" }];
  const primitives = (/** @type {object} */ plan) => {
    const trainer = new LibraryTrainer(walks(), settings, { movements, ...plan });
    return trainer.library().info().primitives.length;
  };
  assert.equal(primitives({}), 4);
  assert.equal(primitives({ shared: ["lower"] }), 3);
  assert.equal(primitives({ shared: [true, true] }), 2);
  assert.throws(() => primitives({ shared: ["legs"] }), {
    code: "training",
    message: 'the plan: `shared`: expected some of the parts lower, upper, found "legs"',
  });
  assert.throws(() => primitives({ shared: [3] }), {
    code: "training",
    message: /^the plan: `shared\[0\]`: expected the name of a part, or true or false, found 3$/,
  });
});
