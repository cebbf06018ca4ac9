// The declared types against real values: the same fields, the same kinds of values, closed unions that hold
// them all.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { simulatedAnswers } from "../perception/simulated.mjs";
import { differences, readDeclarations } from "./declarations.mjs";
import { installPackage } from "./package.mjs";

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
before(async () => {
  installed = await installPackage();
});
after(() => installed?.remove());

const declared = (/** @type {string} */ folder) =>
  readDeclarations(
    readFileSync(at("crate/wasm/pkg", folder, folder === "web" ? "glue.d.ts" : "vcgpdm.d.ts"), "utf8"),
  );

/** Four short walks of a body in two parts. */
function walks() {
  const { Clip, TrainingSet } = installed.vcgpdm;
  const clip = Clip.sample("walk-1").cut(0, 50);
  const clips = new TrainingSet();
  for (const walk of [clip, Clip.sample("walk-2").cut(0, 50), Clip.sample("walk-3"), Clip.sample("walk-4")])
    clips.add(walk);
  const parts = clip.info().presets.find(({ id }) => id === "lower-upper")?.parts ?? [];
  return { clip, clips, parts };
}

/** @type {import("vcgpdm").Candidate[]} */
const CANDIDATES = [
  { model: "vcgpdm", latent: 2, order: 2, dynamicsIps: 4, poseIps: 4, maxIterations: 2 },
  { model: "vgpdm", latent: 2, order: 2, dynamicsIps: 4, poseIps: 4, maxIterations: 2 },
  { model: "vgpdm", latent: 2, order: 2, dynamicsIps: 5, poseIps: 5, maxIterations: 2 },
  { model: "vgpdm", latent: 2, order: 2, dynamicsIps: 6, poseIps: 6, maxIterations: 2 },
  { model: "map-gpdm", latent: 2, order: 2, maxIterations: 2, balanced: false },
  { model: "map-cgpdm", latent: 2, order: 2, maxIterations: 2, balanced: true },
  { model: "tmp", primitives: 3 },
  { model: "tmp", primitives: null },
  { model: "dmp-discrete", bases: 5 },
  { model: "dmp-rhythmic", bases: 5 },
];

describe("the declared types", () => {
  it("are what the functions give", () => {
    const { types, answers } = declared("web");
    const seen = new Set();
    /** Holds a value against what the function is declared to answer with. */
    const hold = (/** @type {string} */ name, /** @type {unknown} */ value) => {
      const type = answers.get(name);
      assert.ok(type, `${name} is declared`);
      assert.deepEqual(differences(types, type, value, name, seen), []);
    };
    const { Clip, Evaluation, Fold, Results, SyntheticExperiment, Trainer } = installed.vcgpdm;
    hold("Clip.samples", Clip.samples());
    const { clip, clips, parts } = walks();
    hold("Clip.info", clip.info());
    for (const one of [clip, clip.cut(0, 20).withUp("z"), clip.withBonesOf(clip)])
      hold("Clip.state", one.state());

    const settings = {
      parts,
      latent: 2,
      dynamicsIps: 4,
      poseIps: 4,
      order: 2,
      framesPerSecond: 15,
      seed: 1,
      maxIterations: 16,
      poseWeight: /** @type {const} */ ("balanced"),
      ownRollouts: true,
    };
    const { parts: _, framesPerSecond: __, seed: ___, ...size } = settings;
    const cost = installed.vcgpdm.trainingCost(size, 100, [30, 33]);
    hold("trainingCost", cost);
    hold("usualSettings", installed.vcgpdm.usualSettings(9));
    assert.ok(cost.seconds > 0 && cost.bytes > 0);
    const { documentKind } = installed.vcgpdm;
    for (const text of ["[]", "{}", '{ "version": 1, "format": "vcgpdm model" }'])
      hold("documentKind", documentKind(text));
    const trainer = new Trainer(clips, settings);
    const phases = new Set();
    for (let done = false; !done; ) {
      const progress = trainer.step();
      hold("Trainer.step", progress);
      phases.add(progress.phase);
      done = progress.done;
    }
    assert.deepEqual([...phases], ["couplings-kernels-inducing-points", "everything", "own-rollouts"]);
    const model = trainer.model();
    hold("Model.info", model.info());
    const coupled = types.get("CoupledModelInfo");
    assert.ok(coupled);
    seen.add("CoupledModelInfo");
    assert.deepEqual(differences(types, coupled, model.info(), "CoupledModelInfo", seen), []);
    assert.deepEqual(model.info().provenance.settings, settings);
    const rollout = model.rollout({ frames: 60, sequence: 0 });
    hold("Rollout.weights", rollout.weights());
    const measures = rollout.measures(15);
    hold("Rollout.measures", measures);
    assert.deepEqual([measures.limbs.length, measures.parts.length], [4, 2]);
    hold("Rollout.health", rollout.health());
    const density = rollout.latentLogDensity();
    hold("Rollout.latentLogDensity", density);
    const { rollout: ofRollout, training, difference } = density;
    assert.ok(ofRollout !== null && training !== null && difference !== null);
    assert.ok(Math.abs(difference - (ofRollout - training)) < 1e-9);
    const alpha = [
      [1, 50],
      [50, 0.001],
    ];
    const other = model.rollout({ frames: 60, alpha }).latentLogDensity();
    assert.ok((other.rollout ?? 0) < ofRollout, "the motion is less likely");
    assert.equal(other.training, training);
    hold("Rollout.latentField", rollout.latentField(0, [[0, 0]]));
    const [part] = model.info().parts;
    const observed = { given: [part?.name ?? ""], until: 1 };
    hold("Completion.scores", model.complete(installed.vcgpdm.Clip.sample("walk-3"), observed).scores());

    const results = Results.empty(clips, { parts, framesPerSecond: 15 });
    hold("Results.setting", results.setting());
    // On all other trials all candidates, on fewer the first: growth is told from three numbers of trials on.
    for (const trainingTrials of [3, 2, 1]) {
      const fold = new Fold(clips, { parts, framesPerSecond: 15 }, { heldOut: 3, trainingTrials });
      for (const candidate of trainingTrials === 3 ? CANDIDATES : CANDIDATES.slice(0, 1)) {
        const evaluation = new Evaluation(fold, candidate, 0);
        for (let done = false; !done; ) {
          const progress = evaluation.step();
          hold("Evaluation.step", progress);
          done = progress.done;
        }
        const outcome = evaluation.prediction().outcome(0.1);
        hold("Prediction.outcome", outcome);
        results.add({ candidate, heldOut: 3, trainingTrials, seed: 0 }, outcome);
      }
    }
    // Failures come from files.
    const file = JSON.parse(results.toJson());
    const [first] = file.finished;
    file.finished.push({ ...first, job: { ...first.job, seed: 1 }, outcome: null, failure: "why" });
    const more = Results.fromJson(JSON.stringify(file));
    hold("Results.finished", more.finished());
    // So do rivals, and more about predictions.
    const ways = [0.1, 0.2];
    const speeds = { predicted: 0.9, recorded: 1 };
    const bands = { within_50: 0.5, within_95: 0.9, log_density: 40 };
    const details = {
      ...{ first_half_second: ways, own_path: ways, speed: speeds, foot_slide: speeds },
      ...{ still_at_20_s: false, bands },
    };
    for (const candidate of [
      { model: "promp", bases: 9 },
      { model: "ar", components: 6, order: 2 },
    ])
      file.finished.push({
        ...first,
        job: { ...first.job, candidate },
        outcome: { ...first.outcome, details },
      });
    const comparison = Results.fromJson(JSON.stringify(file)).comparison();
    assert.ok(
      Object.values(comparison).every((list) => list.length > 0),
      "each table has a row",
    );
    hold("Results.comparison", comparison);
    const planned = more.jobs(plan());
    hold("Results.jobs", planned);
    const costs = planned.map(({ job }) => more.costOf(clips, job));
    for (const cost of costs) hold("Results.costOf", cost);
    assert.ok(costs.some(({ seconds, bytes }) => seconds > 0 && bytes > 0));

    const experiment = new SyntheticExperiment(1, true);
    hold("SyntheticExperiment.step", experiment.step());
    hold("SyntheticExperiment.truth", experiment.truth());
    hold("SyntheticExperiment.findings", experiment.findings());

    const { Model, Table } = installed.vcgpdm;
    hold("Table.info", Table.of("a table", ["x"], new Float64Array([1, 2, 3]), 0.1).info());
    for (const kind of ["vcgpdm", "map-cgpdm", "tmp", "dmp-rhythmic", "series", "combination"]) {
      const text = readFileSync(at("crate/vcgpdm/tests/library/documents", `${kind}.json`), "utf8");
      const any = Model.fromJson(text);
      hold("Model.info", any.info());
      assert.equal(any.toJson(), text);
      const rolled = any.rollout({ frames: 7 });
      hold("Rollout.weights", rolled.weights());
      assert.equal(rolled.values().length, 7 * any.info().columns.length, kind);
      assert.equal(rolled.toCsv().split("\n").length, 9);
      assert.equal(any.info().alpha !== null, ["vcgpdm", "series", "combination"].includes(kind), kind);
      if (kind !== "series") assert.equal(rolled.toClip().info().frames, 7);
    }

    const library = readFileSync(at("crate/vcgpdm/tests/library/documents/library.json"), "utf8");
    const { Library } = installed.vcgpdm;
    const [whole, some] = [
      library,
      readFileSync(at("crate/vcgpdm/tests/library/documents/primitives.json"), "utf8"),
    ].map((text) => Library.fromJson(text));
    assert.ok(whole && some);
    // The second has primitives that were learned again.
    for (const one of [whole, some]) hold("Library.info", one.info());
    hold("Library.motion", whole.motion([0, 1]));
    const walk = new installed.vcgpdm.TrainingSet();
    walk.add(whole.movement(0).rollout({ frames: 12 }).toClip());
    hold("Recognition.segments", whole.recognise(walk).segments());
    const { Study, analysePerception, perceptionFigures } = installed.vcgpdm;
    const text = readFileSync(at("www/public/study/walks.study.json"), "utf8");
    const study = Study.fromJson(text);
    hold("Study.info", study.info);
    hold("Study.trials", study.trials(1));
    const given = [{ name: "a.csv", text: simulatedAnswers(study, "a", 1).csv }];
    hold("analysePerception", analysePerception(text, given, { draws: 100 }));
    hold("perceptionFigures", perceptionFigures(text, given, { draws: 100 }));

    const inputs = [
      "AnswersFile",
      "BvhOptions",
      "CandidateOptions",
      "ComparisonSettings",
      "CompleteOptions",
      "ErrorCode",
      "FoldOptions",
      "InitInput",
      "InitOutput",
      "JobOptions",
      "LibraryPlan",
      "MadeMovement",
      "NamedPart",
      "PerceptionOptions",
      "Plan",
      "PlanePicture",
      "Reading",
      "RolloutOptions",
      "StudyPreset",
      "SyncInitInput",
      "TablePart",
      "TableTrainingOptions",
      "TableTrainingSettings",
      "TrainingOptions",
      "VcgpdmError",
      "WalkStart",
    ];
    const unseen = [...types.keys()].filter((name) => !seen.has(name));
    assert.deepEqual(unseen.sort(), inputs, "every other type was held against a value");
  });

  it("ask for what the functions need", () => {
    const { types } = declared("web");
    const { clips, parts } = walks();
    const { Fold, Model, Results, Trainer } = installed.vcgpdm;
    const results = Results.empty(clips, { parts, framesPerSecond: 15 });
    const settings = {
      parts,
      latent: 2,
      dynamicsIps: 4,
      poseIps: 4,
      order: 2,
      framesPerSecond: 15,
      seed: 1,
      maxIterations: 1,
    };
    const trainer = new Trainer(clips, settings);
    const model = trainer.model();
    /** @type {[string, object, (value: any) => unknown][]} */
    const inputs = [
      ["TrainingOptions", settings, (value) => new Trainer(clips, value)],
      [
        "ComparisonSettings",
        { parts, framesPerSecond: 15 },
        (value) => new Fold(clips, value, { heldOut: 0 }),
      ],
      [
        "FoldOptions",
        { heldOut: 1, trainingTrials: 1 },
        (value) => new Fold(clips, { parts, framesPerSecond: 15 }, value),
      ],
      ["Plan", plan(), (value) => results.jobs(value)],
      [
        "RolloutOptions",
        { frames: 5, sequence: 0, alpha: null, reading: "as-learned" },
        (value) => model.rollout(value),
      ],
    ];
    // A plan is declared whole, for programs that show one; the function takes a part of it.
    for (const [name, value, use] of inputs) {
      const type = types.get(name);
      assert.ok(type?.kind === "object", name);
      assert.deepEqual(differences(types, type, value, name), []);
      use(value);
      for (const [field, { optional }] of type.fields) {
        const rest = Object.fromEntries(Object.entries(value).filter(([key]) => key !== field));
        if (optional || name === "Plan") use(rest);
        else
          assert.throws(
            () => use(rest),
            new RegExp(`: missing field \`${field}\``),
            `${name} without ${field}`,
          );
      }
    }
    const reading = types.get("Reading");
    assert.ok(reading?.kind === "union");
    for (const option of reading.options)
      model.rollout({ frames: 5, sequence: 0, reading: /** @type {any} */ (option).value });
    assert.ok(Model.fromJson(model.toJson()));
  });

  it("are the same in the smaller build, as far as it goes", () => {
    const [whole, small] = [declared("web"), declared("player")];
    for (const [name, type] of small.types) assert.deepEqual(type, whole.types.get(name), name);
    for (const [name, type] of small.answers) assert.deepEqual(type, whole.answers.get(name), name);
    const { types } = whole;
    assert.deepEqual(
      ["ModelInfo", "TrainingProgress", "Comparison", "SyntheticTruth"].map((name) => [
        types.has(name),
        small.types.has(name),
      ]),
      [
        [true, true],
        [true, false],
        [true, false],
        [true, false],
      ],
    );
  });
});

/** @returns {import("vcgpdm").Plan} */
function plan() {
  return {
    models: ["vcgpdm", "vgpdm", "map-gpdm", "map-cgpdm", "tmp", "dmp-discrete", "dmp-rhythmic"],
    latent: 2,
    order: 2,
    maxIterations: 2,
    ips: [4, 5, 6],
    primitives: [null, 3],
    bases: [5],
    balanced: false,
    heldOut: [3],
    seeds: [0, 1],
    trainingTrials: [],
    growth: true,
  };
}
