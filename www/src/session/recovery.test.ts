import { beforeEach, describe, expect, it } from "vitest";
import { RecordWriter } from "./records";
import { recover } from "./recovery";
import { clip, nothing, run } from "./visit.fake";

const library = { text: "{}", title: "mine.json", unsaved: true };
const AT = 1_700_000_000_000;

type Records = Map<string, unknown>;
let records: Records;
beforeEach(() => {
  const runs = [run(1, 2), { ...run(2, 3), clips: [clip("jump")] }];
  const holdings = { ...nothing, clips: [clip("walk")], runs, chosen: runs[1] ?? null, model: "{}" };
  const all = { ...holdings, results: "{}", library };
  records = structuredClone(new RecordWriter().changes(all, AT)) ?? expect.fail();
});

/** Changes fields of a record. */
const change = (name: string, fields: object) =>
  records.set(name, { ...(records.get(name) as object), ...fields });
const changeClip = (fields: object) =>
  records.set("clips", [{ ...(records.get("clips") as object[])[0], ...fields }]);
const changeStep = (fields: object) =>
  change("run 1", { steps: [{ ...(records.get("run 1") as { steps: object[] }).steps[0], ...fields }] });

const ALL = "a clip, 2 trainings, a model, a comparison and a library of primitives";

it("what was written is recovered whole", () => {
  const { at, contents, whole, holdings } = recover(records);
  expect([at, contents, whole]).toEqual([AT, ALL, true]);
  expect([holdings.chosen?.id, holdings.runs[1]?.clips[0]?.title]).toEqual([2, "jump"]);
});

it("a record without what earlier versions did not write is whole", () => {
  const { unsaved: _, ...about } = records.get("about") as Record<string, unknown>;
  records.set("about", about);
  const { whole, holdings } = recover(records);
  expect([whole, holdings.unsaved]).toEqual([true, { model: true, results: true }]);
});

it("the state of a motion that version 0.2 wrote with spaces has hyphens now", () => {
  const health = { state: "leaves the training range", from: 1, part: 0, rank: 1 };
  change("run 1", { model: { text: "{}", latents: [new Float64Array(6)], health } });
  const { whole, holdings } = recover(records);
  expect([whole, holdings.runs[0]?.model?.health?.state]).toEqual([true, "leaves-training-range"]);
  expect(holdings.runs[0]?.model?.error).toBe(null);
});

describe("a damaged record is left out and the rest recovered:", () => {
  const withoutTime = (at: number | null) => expect(at).toBe(null);
  it.each([
    ["a time that is no number", () => change("about", { at: Number.NaN })],
    ["a time that no calendar has", () => change("about", { at: 1e20 })],
    ["a time as text", () => change("about", { at: "yesterday" })],
    ["no record about the others", () => records.delete("about")],
    ["text in place of that record", () => records.set("about", "x")],
    ["null in place of that record", () => records.set("about", null)],
  ])("%s", (_, damage) => {
    damage();
    const { at, contents, whole } = recover(records);
    withoutTime(at);
    expect([contents, whole]).toEqual([ALL, false]);
  });

  it.each([
    ["a list of runs that is none", "2 trainings", () => change("about", { order: undefined })],
    ["an address that is no text", "2 trainings", () => change("about", { fragment: { a: 1 } })],
    ["a run that is missing", "a training", () => records.delete("run 1")],
    ["a run that is text", "a training", () => records.set("run 1", "x")],
    ["a run without steps", "a training", () => change("run 1", { steps: undefined })],
    ["a step without a bound", "a training", () => changeStep({ bound: undefined })],
    ["a run without its settings", "a training", () => change("run 1", { settings: null })],
    ["a run in an unknown state", "a training", () => change("run 1", { state: "dreaming" })],
    ["a run with a model without latents", "a training", () => change("run 1", { model: { text: "{}" } })],
    ["a run whose clip has lost its file", "a training", () => records.delete("file 2")],
  ])("%s", (_, trainings, damage) => {
    damage();
    const { contents, whole } = recover(records);
    expect([contents, whole]).toEqual([ALL.replace("2 trainings", trainings), false]);
  });

  it.each([
    ["no list of clips", () => records.delete("clips")],
    ["clips that are no list", () => records.set("clips", { length: 1 })],
    ["a clip without a source", () => changeClip({ source: undefined })],
    ["a clip whose end is text", () => changeClip({ end: "90" })],
    ["a clip that has lost its file", () => records.delete("file 1")],
    ["a file that is text", () => records.set("file 1", "HIERARCHY")],
  ])("%s", (_, damage) => {
    damage();
    const { contents, whole } = recover(records);
    expect([contents, whole]).toEqual([ALL.replace("a clip, ", ""), false]);
  });

  it.each([
    ["a model that is a number", "a model, ", () => records.set("model", 5)],
    ["results that are an object", ", a comparison", () => records.set("results", {})],
    ["a library without text", " and a library of primitives", () => change("library", { text: null })],
  ])("%s", (_, lost, damage) => {
    damage();
    const { contents, whole } = recover(records);
    const words = lost.startsWith(" and")
      ? "a clip, 2 trainings, a model and a comparison"
      : lost.startsWith(",")
        ? "a clip, 2 trainings, a model and a library of primitives"
        : ALL.replace(lost, "");
    expect([contents, whole]).toEqual([words, false]);
  });
});

it("nothing but junk leaves nothing to bring back", () => {
  const junk = new Map<string, unknown>([
    ["about", 5],
    ["x", { "run 1": [] }],
  ]);
  expect(recover(junk)).toMatchObject({ at: null, contents: "", whole: false });
});
