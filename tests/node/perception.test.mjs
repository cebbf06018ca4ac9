// The graphics Turing test from Node: the study that comes with the page, what a participant is shown, and
// what answers say.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { simulatedAnswers } from "../perception/simulated.mjs";

const vcgpdm = builtPackage();

const text = readFileSync(at("www/public/study/walks.study.json"), "utf8");
const opened = () => vcgpdm.Study.fromJson(text);

/**
 * Holds values against each other: numbers up to their last digits, names in camelCase against snake_case.
 */
function close(/** @type {any} */ found, /** @type {any} */ expected, where = "results") {
  if (typeof expected === "number") {
    assert.ok(
      Math.abs(found - expected) <= 1e-6 * (1 + Math.abs(expected)),
      `${where}: ${found}, expected ${expected}`,
    );
  } else if (expected !== null && typeof expected === "object") {
    const names = Object.keys(expected);
    const camel = (/** @type {string} */ name) =>
      name.replace(/_([a-z0-9])/g, (_, letter) => letter.toUpperCase());
    assert.deepEqual(Object.keys(found).sort(), names.map(camel).sort(), where);
    for (const name of names) close(found[camel(name)], expected[name], `${where}.${name}`);
  } else assert.deepEqual(found, expected, where);
}

describe("a study", () => {
  it("says what it holds, and shows every movement on its way along z", () => {
    const study = opened();
    const { info } = study;
    assert.deepEqual(
      [info.look, info.framesPerSecond, info.seconds, info.frames, info.crossSeconds],
      ["figure", 30, 3.5, 105, 0.75],
    );
    assert.match(info.texts.instructions, /it stands for the natural movement here/);
    const { names, parents, joints, height, feet, dots } = info.skeleton;
    assert.deepEqual([names.length, parents.length, parents[0], height, dots.length], [26, 26, -1, 1.7, 13]);
    assert.ok(
      parents.slice(1).every((parent, k) => parent >= 0 && parent <= k) && joints === 21 && feet !== null,
    );
    const kinds = (/** @type {(s: import("vcgpdm").StudyStimulus) => boolean} */ wanted) =>
      info.stimuli.filter(wanted).length;
    assert.equal(
      kinds(({ kind, seen }) => kind === "natural" && seen),
      4,
    );
    assert.equal(
      kinds(({ kind, seen }) => kind === "natural" && !seen),
      2,
    );
    assert.equal(
      kinds(({ failed }) => failed),
      2,
    );
    for (const [k, { scores, settings, model }] of info.stimuli.entries()) {
      const positions = study.positions(k);
      assert.equal(positions.length, 105 * 26 * 3);
      const lowest = positions.reduce((low, place, axis) => (axis % 3 === 1 ? Math.min(low, place) : low), 1);
      assert.ok(lowest > -0.1 && lowest < 0.01, `${k}: ${lowest}`);
      assert.equal(model, settings?.model ?? null);
      if (model === "vgpdm" || model === "vcgpdm")
        assert.ok(
          Math.abs((scores?.dynamics ?? NaN) + (scores?.pose ?? NaN) - (scores?.bound ?? NaN)) < 1e-6,
        );
    }
    assert.deepEqual(JSON.parse(study.toJson()), JSON.parse(text));
  });

  it("shows the same participant the same, half of the natural ones on the left", () => {
    const study = opened();
    const trials = study.trials(7);
    assert.deepEqual(opened().trials(7), trials);
    assert.notDeepEqual(study.trials(8), trials);
    const count = (/** @type {string} */ kind) => trials.filter((trial) => trial.kind === kind).length;
    assert.deepEqual(["comparison", "attention", "catch"].map(count), [52, 4, 4]);
    const sides = trials.filter(({ naturalSide }) => naturalSide === "left").length;
    assert.ok(Math.abs(sides - 28) <= 4, `${sides}`);
    assert.ok(trials.every(({ headingDegrees }) => headingDegrees >= 0 && headingDegrees < 360));
  });

  it("is changed without a change of what is shown", () => {
    const study = opened();
    const { hash, texts } = study.info;
    const changed = study
      .withDesign("p3-part-1")
      .withLook("points")
      .withTexts({ ...texts, end: "Bye." })
      .withFailed(["tmp-1-trial-1"]);
    const { info } = changed;
    assert.deepEqual(
      [info.look, info.texts.end, info.design.blocks, info.pauseSeconds],
      ["points", "Bye.", 4, 30],
    );
    assert.deepEqual(
      info.stimuli.filter(({ failed }) => failed).map(({ id }) => id),
      ["tmp-1-trial-1"],
    );
    assert.equal(changed.trials(0).length, 643);
    assert.equal(info.hash, hash);
    assert.equal(study.withDesign("p2").positions(0).length, 54 * 26 * 3);
    assert.equal(study.info.look, "figure", "the first stays as it was");
  });

  it("is made of a comparison that ran here", () => {
    const { Clip, Evaluation, Fold, StudyMaker, TrainingSet } = vcgpdm;
    const clips = new TrainingSet();
    const walks = ["walk-1", "walk-2"].map((id) => Clip.sample(id));
    for (const walk of walks) clips.add(walk);
    const [body] = walks;
    assert.ok(body);
    const parts = body.info().presets.find(({ id }) => id === "lower-upper")?.parts ?? [];
    const maker = new StudyMaker(body, 3, 30);
    /** @type {import("vcgpdm").Candidate} */
    const candidate = { model: "dmp-rhythmic", bases: 15 };
    for (const trial of [0, 1]) {
      const fold = new Fold(clips, { parts, framesPerSecond: 30 }, { heldOut: trial });
      const movement = { trial, name: `walk ${trial + 1}`, frameTime: fold.frameTime };
      maker.addNatural(movement, fold.actual(), true);
      const evaluation = new Evaluation(fold, candidate, 0);
      while (!evaluation.step().done);
      const prediction = evaluation.prediction();
      maker.addGenerated(movement, prediction.positions(), candidate, 0, prediction.outcome(1));
    }
    const study = maker.study("Two walks", "class", "figure", 3);
    const { info } = study;
    assert.deepEqual(
      info.stimuli.map(({ id }) => id),
      ["trial-1", "dmp-rhythmic-15-trial-1", "trial-2", "dmp-rhythmic-15-trial-2"],
    );
    assert.deepEqual([info.seconds, info.title, info.design.seed], [3, "Two walks", 3]);
    assert.ok((info.stimuli[1]?.scores?.mse ?? 0) > 0);
    assert.equal(study.trials(1).length, 52);
    const short = { trial: 2, name: "short", frameTime: 1 / 30 };
    assert.throws(
      () => maker.addNatural(short, study.positions(0).slice(0, 26 * 3 * 9), true),
      /trial-3: expected a movement/,
    );
  });
});

describe("answers", () => {
  it("say the same as in the terminal", () => {
    const { analysePerception, perceptionJson } = vcgpdm;
    const answers = ["p1", "p2"].map((name) => ({
      name: `${name}.csv`,
      text: readFileSync(at("tests/perception", `${name}.csv`), "utf8"),
    }));
    // What `vcgpdm perception` writes; its own test holds it to the same file.
    const stored = JSON.parse(readFileSync(at("tests/perception/results.json"), "utf8"));
    const expected = { ...stored, engine: `vcgpdm ${vcgpdm.version()}` };
    close(analysePerception(text, answers), expected);
    const document = JSON.parse(perceptionJson(text, answers, { draws: 100 }));
    assert.deepEqual(Object.keys(document), Object.keys(expected));
    assert.equal(document.best.length, expected.best.length);
  });

  it("of a fresh participant are read as CSV and as JSON", () => {
    const { analysePerception, perceptionFigures } = vcgpdm;
    const study = opened().withDesign("p3-part-1");
    const { csv, rows } = simulatedAnswers(study, "fresh", 77);
    const document = study.toJson();
    const results = analysePerception(document, [{ name: "fresh.csv", text: csv }], { draws: 1000 });
    assert.deepEqual(
      analysePerception(document, [{ name: "a", text: JSON.stringify(rows) }], { draws: 1000 }),
      results,
    );
    const wrapped = JSON.stringify({ format: "answers", answers: rows });
    assert.deepEqual(analysePerception(document, [{ name: "a", text: wrapped }], { draws: 1000 }), results);
    assert.deepEqual(
      [results.participants[0]?.name, results.participants[0]?.attentionHits, results.all.trials],
      ["fresh", 17, 620],
    );
    const fooled = rows.filter(
      ({ kind, response, natural_side }) => kind === "comparison" && response !== natural_side,
    );
    assert.equal(results.all.hits, fooled.length);
    assert.equal(results.needed.toTell, 158);
    const all = results.regressions.find(({ model, score }) => model === null && score === "dtw-mse");
    assert.ok(
      (all?.weights[1] ?? 0) > 0 && (all?.logBayesFactor ?? 0) > 0,
      "the error says how natural it looks",
    );
    const figures = perceptionFigures(document, [{ name: "fresh.csv", text: csv }]);
    assert.ok(figures.some(({ name, csv }) => name === "settings.csv" && csv.split("\n").length === 20));
  });

  it("that cannot be are refused with file and line", () => {
    const { analysePerception } = vcgpdm;
    const { csv } = simulatedAnswers(opened(), "p", 1);
    const say = (/** @type {string} */ changed) => () =>
      analysePerception(text, [{ name: "p.csv", text: changed }]);
    assert.throws(
      say(csv.replace('"comparison"', '"guess"')),
      /^VcgpdmError: p\.csv: line \d+, kind: expected comparison/,
    );
    assert.throws(
      say(csv.replaceAll(opened().info.hash, "0".repeat(64))),
      /line 2, study: expected the study /,
    );
    assert.throws(say(""), /p\.csv: expected answers to comparisons, found none/);
    assert.throws(
      () => analysePerception(text, [], { ceiling: 3 }),
      /the ceiling: expected a number above 0/,
    );
  });
});
