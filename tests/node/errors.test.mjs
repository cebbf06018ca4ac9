// What the package throws: errors of one name, with a code that a program can tell apart and words that a
// person understands.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";

const vcgpdm = builtPackage();

it("errors have a name, a code of the declared ones, and words", () => {
  const {
    Clip,
    Evaluation,
    Fold,
    Model,
    Results,
    Study,
    StudyMaker,
    SyntheticExperiment,
    Table,
    Trainer,
    TrainingSet,
  } = vcgpdm;
  const clip = Clip.sample("walk-1").cut(0, 60);
  const set = (/** @type {import("vcgpdm").Clip[]} */ ...clips) => {
    const set = new TrainingSet();
    for (const clip of clips) set.add(clip);
    return set;
  };
  const clips = set(clip, Clip.sample("walk-2"));
  const { parts, presets } = { parts: [{ name: "body", joints: [0] }], presets: clip.info().presets };
  const whole = presets.find(({ id }) => id === "whole")?.parts ?? [];
  const settings = {
    parts: whole,
    latent: 1,
    dynamicsIps: 3,
    poseIps: 3,
    order: 1,
    framesPerSecond: 15,
    seed: 1,
    maxIterations: 1,
  };
  const model = new Trainer(clips, settings).model();
  const common = { parts: whole, framesPerSecond: 15 };
  const results = Results.empty(clips, common);
  const others = Results.empty(set(clip, Clip.sample("walk-3")), common);
  const other =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n";
  const bytes = new TextEncoder().encode(other);

  const longer = clip
    .toBvh()
    .replace(/OFFSET .*/g, (line) =>
      line.replace(/-?\d+(\.\d+)?/g, (length) => String(1.1 * Number(length))),
    );
  const taller = Clip.read("taller.bvh", new TextEncoder().encode(longer));

  /** @type {[string, () => unknown, RegExp][]} */
  const cases = [
    ["clip", () => Clip.read("no.bvh", new Uint8Array()), /^no\.bvh/],
    ["clip", () => Clip.sample("run-1"), /expected the id of a sample clip, found "run-1"/],
    ["clip", () => clip.cut(5, 5), /expected frames from 0 to 60/],
    ["clips", () => new Trainer(new TrainingSet(), settings), /expected at least one clip/],
    ["clips", () => clips.add(Clip.read("other.bvh", bytes)), /other\.bvh cannot be trained together with/],
    ["bones", () => clips.add(taller), /taller\.bvh cannot be trained together with .* its offset differs/],
    [
      "clips",
      () => Clip.read("other.bvh", bytes).withBonesOf(clip),
      /other\.bvh cannot be trained together with/,
    ],
    ["parts", () => new Trainer(clips, { ...settings, parts: [] }), /expected at least one part/],
    [
      "parts",
      () => new Trainer(clips, { ...settings, parts: "wings" }),
      /^parts: expected a list of parts or a split of this body \(.*lower,upper.*\), found "wings"$/,
    ],
    [
      "parts",
      () => new Trainer(clips, { ...settings, parts: [{ name: "a", joints: ["Tail"] }] }),
      /expected the name of one of the skeleton's 21 joints, found "Tail"/,
    ],
    ["clip", () => clip.withUp(/** @type {any} */ ("w")), /expected x, y, z, -x, -y or -z/],
    [
      "clip",
      () => Clip.read("a.bvh", /** @type {any} */ ({})),
      /expected a string, an ArrayBuffer, a Uint8Array or a Blob, found an object/,
    ],
    [
      "rollout",
      () => model.rollout({ frames: 1.5 }),
      /^rollout: `frames`: expected a whole number from 0 to 4294967295, found 1.5$/,
    ],
    [
      "settings",
      () => new Trainer(clips, { ...settings, seed: -1 }),
      /^settings: `seed`: expected a whole number from 0 to \d+, found -1$/,
    ],
    ["parts", () => new Trainer(clips, { ...settings, parts }), /./],
    [
      "settings",
      () => new Trainer(clips, { ...settings, latent: 0 }),
      /the latent dimension must be from 1 to 100/,
    ],
    [
      "settings",
      () => new Trainer(clips, /** @type {any} */ ({ ...settings, latent: "3" })),
      /^settings: `latent`: expected a whole number from 0 to \d+, found "3"$/,
    ],
    [
      "settings",
      () =>
        new Evaluation(new Fold(clips, common, { heldOut: 0 }), /** @type {any} */ ({ model: "gplvm" }), 0),
      /^candidate: `model`: expected one of "vcgpdm", .*"dmp-rhythmic", found "gplvm"$/,
    ],
    ["training", () => new Trainer(set(clip.cut(0, 2)), { ...settings, order: 9 }), /./],
    ["model", () => Model.fromJson("{}"), /./],
    ["model", () => model.poseIps(1), /expected a part from 0 to 0, found 1/],
    [
      "model",
      () => model.poseIpWeights(0, 3, new Float64Array(1)),
      /expected an inducing point from 0 to 2, found 3/,
    ],
    ["rollout", () => model.rollout({ frames: 0, sequence: 0 }), /expected from 1 to \d+ frames, found 0/],
    [
      "rollout",
      () => model.rollout({ frames: 9, handles: { tempo: 2 } }),
      /a tmp, dmp-.* found a vgpdm model$/,
    ],
    [
      "rollout",
      () => model.rollout({ frames: 5, sequence: 0, alpha: [[0]] }),
      /expected a positive coupling variance/,
    ],
    [
      "rollout",
      () => model.rollout({ frames: 5, sequence: 0, alpha: [[1], [1, 2]] }),
      /^rollout: `alpha`: expected rows of 1 numbers/,
    ],
    [
      "rollout",
      () => model.rollout(/** @type {any} */ ({ frames: 5, sequence: 0, reading: "guessed" })),
      /^rollout: `reading`: expected "as-learned" or "re-inferred", found "guessed"$/,
    ],
    ["comparison", () => new Fold(clips, common, { heldOut: 2 }), /expected a trial from 0 to 1, found 2/],
    [
      "comparison",
      () => new Fold(clips, common, { heldOut: 0, trainingTrials: 2 }),
      /expected from 1 to 1 trials to train on, found 2/,
    ],
    ["comparison", () => Results.empty(set(clip), common), /expected at least two trials, found 1/],
    [
      "results",
      () => Results.fromJson("{}"),
      /^expected the results of an evaluation: missing field `format`/,
    ],
    ["results", () => results.merge(others), /^these results are of other trials/],
    ["study", () => Study.fromJson("{}"), /^expected a study with "format": "vcgpdm study", found no format/],
    [
      "study",
      () => new StudyMaker(clip, 2, 30).study("none", "class", "figure", 1),
      /^at stimuli: expected from 2 to 5000, found 0/,
    ],
    [
      "numerics",
      () => new SyntheticExperiment(1, true).free() ?? model.pose(0, new Float64Array([NaN])),
      /./,
    ],
  ];
  // Tables, and models of other kinds.
  const table = Table.of("t", ["x", "y"], new Float64Array([1, 2, 3, 4, 5, 7]), 0.1);
  const task = { ...settings, parts: [{ name: "all", columns: ["x", "knee"] }] };
  const tables = new TrainingSet();
  tables.addTable(table);
  const tmp = readFileSync(at("crate/vcgpdm/tests/library/documents/tmp.json"), "utf8");
  const series = readFileSync(at("crate/vcgpdm/tests/library/documents/series.json"), "utf8");
  cases.push(
    [
      "table",
      () => Table.read("t.csv", new TextEncoder().encode("x,y\n1,gap\n")),
      /^t\.csv, line 2, column 2 \(y\): /,
    ],
    [
      "table",
      () => Table.of("t", ["x", "y"], new Float64Array(3), 0.1),
      /expected rows of 2 numbers, found 3/,
    ],
    ["clips", () => new Trainer(new TrainingSet(), task), /expected at least one clip/],
    ["clips", () => tables.add(clip), /expected a table as the others, found a clip/],
    ["table", () => clips.addTable(table), /expected a clip as the others, found a table/],
    ["parts", () => new Trainer(tables, task), /part "all": expected one of the columns, found "knee"/],
    ["model", () => Model.fromJson(tmp).poseIps(0), /expected a vcgpdm or vgpdm model, found a tmp model/],
    [
      "model",
      () => Model.fromJson(series).rollout({ frames: 5 }).toClip(),
      /expected a model of a body, found a model of tables/,
    ],
    [
      "rollout",
      () => Model.fromJson(tmp).rollout({ frames: 5, alpha: [[1]] }),
      /expected a vcgpdm or vgpdm model for other couplings/,
    ],
    // Options that there are not.
    [
      "settings",
      () => new Trainer(clips, /** @type {any} */ ({ ...settings, latents: 3 })),
      /unknown field `latents`/,
    ],
    [
      "rollout",
      () => model.rollout(/** @type {any} */ ({ frames: 5, sequence: 0, sequnce: 1 })),
      /unknown field `sequnce`/,
    ],
    [
      "comparison",
      () => Results.empty(clips, /** @type {any} */ ({ ...common, folds: 3 })),
      /unknown field `folds`/,
    ],
  );
  // Objects after their end, called or given as an argument.
  const gone = Clip.sample("walk-1");
  gone.free();
  cases.push(
    ["freed", () => gone.info(), /^expected an object in use, found one after its free\(\)$/],
    ["freed", () => clips.add(gone), /^expected an object in use/],
    [
      "argument",
      () => new /** @type {any} */ (Model)("x"),
      /^new Model makes no object: use Model\.fromJson$/,
    ],
    ["clip", () => Clip.sample("walk-1").resample(1e300), /frames a second, found 1e300$/],
  );
  // Arguments of another type.
  const odd = /** @type {any} */ ({ number: 7, nothing: undefined, word: "x", object: {}, nil: null });
  cases.push(
    [
      "clip",
      () => Clip.read("a", odd.number),
      /^the file: expected a string, an ArrayBuffer, a Uint8Array or a Blob, found 7/,
    ],
    ["clip", () => Clip.read("a", odd.nil), /^the file: expected a string, .* or a Blob, found null/],
    ["table", () => Table.read("a", odd.nil), /^the file: expected a string, .* or a Blob, found null/],
    ["settings", () => new Trainer(clips, odd.nil), /^settings: expected an object, found null/],
    [
      "parts",
      () => new Trainer(clips, { ...settings, parts: odd.nil }),
      /^parts: expected a list of parts or a split of this body \(.*\), found null$/,
    ],
    ["argument", () => clips.add(odd.nil), /^expected an instance of Clip, found null/],
    ["argument", () => new Trainer(odd.word, settings), /^expected an instance of TrainingSet, found string/],
    ["clip", () => Clip.sample(odd.number), /^the id of a sample: expected a text, found 7/],
    ["clip", () => Clip.read(odd.nothing, new Uint8Array(3)), /^the name: expected a text, found undefined/],
    ["model", () => Model.fromJson(odd.object), /^the document: expected a text, found an object/],
    ["results", () => Results.fromJson(odd.number), /^the document: expected a text, found 7/],
    ["clip", () => clip.cut(-1, 5), /^the first frame: expected a whole number from 0 to \d+, found -1/],
    ["clip", () => clip.cut(0, 2.5), /^the end: expected a whole number from 0 to \d+, found 2.5/],
    [
      "comparison",
      () => new Evaluation(new Fold(clips, common, { heldOut: 0 }), odd.object, odd.word),
      /^the seed: expected a whole number from 0 to \d+, found "x"/,
    ],
    ["model", () => model.poseIps(odd.word), /^the part: expected a whole number from 0 to \d+, found "x"/],
    [
      "rollout",
      () => model.sampledRollouts({ frames: 5, sequence: 0 }, NaN, 1),
      /^the number of rollouts: .*found NaN/,
    ],
  );
  // Fields of the wrong kind: the place, what was expected and what was found.
  const two = new Trainer(clips, { ...settings, parts: "lower,upper" }).model();
  const plain = (/** @type {unknown} */ value) => /** @type {any} */ (value);
  const complete = (/** @type {object} */ options) => () => two.complete(clip, plain(options));
  const state = clip.state();
  cases.push(
    ["rollout", complete({ given: "lower" }), /^complete: `given`: expected a list, found "lower"$/],
    ["rollout", complete({ given: ["lower", 1] }), /^complete: `given\[1\]`: expected a text, found 1$/],
    [
      "rollout",
      complete({ given: ["lower"], until: -1 }),
      /^complete: `until`: expected from 0\.\d+ to \d\.\d+ seconds, found -1$/,
    ],
    ["rollout", complete({ given: ["lower"], until: NaN }), /^complete: `until`: .* seconds, found NaN$/],
    ["rollout", complete(clip), /^complete: expected an object, found an instance of Clip$/],
    [
      "parts",
      () => new Trainer(clips, plain({ ...settings, parts: [{ name: "a", joints: "x" }] })),
      /^parts: `\[0\]\.joints`: expected a list, found "x"$/,
    ],
    ["rollout", () => model.rollout(plain({ alpha: "x" })), /^rollout: `alpha`: expected a list, found "x"$/],
    [
      "rollout",
      () => model.rollout(plain({ frames: {} })),
      /^rollout: `frames`: expected a whole number from 0 to \d+, found an object$/,
    ],
    [
      "rollout",
      () => model.rollout(plain({ frames: [1] })),
      /^rollout: `frames`: expected a whole number from 0 to \d+, found a list$/,
    ],
    [
      "rollout",
      () => model.rollout(plain({ reading: 3 })),
      /^rollout: `reading`: expected "as-learned" or "re-inferred", found 3$/,
    ],
    ["rollout", () => model.rollout(plain([])), /^rollout: expected an object, found a list$/],
    ["model", () => model.withPoints(plain("x"), []), /^poses: expected a list, found "x"$/],
    [
      "clip",
      () => Clip.fromState(plain({ ...state, piece: [1, 2, 3] })),
      /^state: `piece`: expected a list of 2 items, found a list of 3$/,
    ],
    [
      "clip",
      () => Clip.fromState(plain({ ...state, piece: 4 })),
      /^state: `piece`: expected a list of 2 items, found 4$/,
    ],
    [
      "table",
      () => Table.of("t", plain([3]), new Float64Array(3), 0.1),
      /^the columns: `\[0\]`: expected a text, found 3$/,
    ],
    ["argument", () => Table.of("t", ["x"], plain("abc"), 0.1), /^expected a list of numbers, found abc$/],
    ["argument", () => Table.of("t", ["x"], plain([1, "2"])), /^expected a list of numbers, found 2 in it$/],
    ["argument", () => model.pose(0, plain(null)), /^expected a list of numbers, found null$/],
    [
      "comparison",
      () => Results.empty(clips, plain({ framesPerSecond: "x" })),
      /^settings: `framesPerSecond`: expected a number, found "x"$/,
    ],
    [
      "parts",
      () => new Fold(clips, { parts: "wings" }),
      /^parts: expected a list of parts or a split of this body \(.*\), found "wings"$/,
    ],
    [
      "clip",
      () => Clip.read("t.csv", "x,y\n1,2\n3,4\n"),
      /^t\.csv, line 1: expected a BVH file, found a table of numbers, as CSV \(.*Table\.read\)$/,
    ],
    [
      "clip",
      () => clip.toBvh(plain({ plain: true })),
      /^toBvh: unknown field `plain`, expected some of `plainNames`$/,
    ],
  );
  assert.equal(set(clip, taller.withBonesOf(clip)).length, 2);
  const types = readFileSync(at("crate/wasm/pkg/web/glue.d.ts"), "utf8");
  const [declared = ""] = /type ErrorCode =[^;]*/.exec(types) ?? [];
  const codes = [...declared.matchAll(/"([^"]+)"/g)].map(([, code = ""]) => code);
  for (const [code, call, words] of cases) {
    assert.ok(codes.includes(code), code);
    assert.throws(call, (/** @type {any} */ error) => {
      assert.ok(error instanceof Error && error.name === "VcgpdmError", `${error}`);
      assert.match(error.message, words);
      assert.equal(/** @type {any} */ (error).code, code, error.message);
      return true;
    });
  }
  assert.deepEqual(
    codes.filter((code) => !cases.some(([thrown]) => thrown === code)),
    [],
  );
});

it("`train` refuses other arguments before it begins", async () => {
  const { Clip, train } = vcgpdm;
  const clip = Clip.sample("walk-1").cut(0, 60);
  /** @type {[unknown[], string, string][]} */
  const cases = [
    [[clip, null], "settings", "settings: expected an object, found null"],
    [[clip, 7], "settings", "settings: expected an object, found 7"],
    [[null], "argument", "expected an instance of Clip or of Table, or a list of them, found null"],
    [
      [[clip, {}]],
      "argument",
      "expected an instance of Clip or of Table, or a list of them, found an object",
    ],
    [[clip, { onProgress: 3 }], "settings", "settings: `onProgress`: expected a function, found 3"],
    [[clip, { signal: "x" }], "settings", 'settings: `signal`: expected an AbortSignal, found "x"'],
  ];
  for (const [given, code, message] of cases)
    await assert.rejects(/** @type {any} */ (train)(...given), { name: "VcgpdmError", code, message });
});

it("an error of the caller's own getter is passed on", () => {
  const { Clip, Trainer, TrainingSet } = vcgpdm;
  const clips = new TrainingSet();
  clips.add(Clip.sample("walk-1"));
  const mine = new RangeError("mine");
  const settings = {
    get parts() {
      throw mine;
    },
  };
  assert.throws(
    () => new Trainer(clips, /** @type {any} */ (settings)),
    (error) => error === mine,
  );
});

it("names in snake_case are refused with the name to write", () => {
  const { Clip, Results, TrainingSet } = vcgpdm;
  const clips = new TrainingSet();
  clips.add(Clip.sample("walk-1"));
  clips.add(Clip.sample("walk-2"));
  const odd = /** @type {any} */ ({ frames_per_second: 15 });
  assert.throws(() => Results.empty(clips, odd), {
    message: "settings: expected fields in camelCase, found `frames_per_second`; write `framesPerSecond`",
  });
});
