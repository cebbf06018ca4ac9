import { beforeEach, expect, it } from "vitest";
import type { PerceptionResults } from "../engine/whole-protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { AnalysisStore } from "./analysis-store";

let program: FakeProgram;
let store: AnalysisStore;
beforeEach(() => {
  program = new FakeProgram();
  store = new AnalysisStore(program);
});

const file = (name: string, text = name) => ({ name, text });
const named = (title: string) => ({ title }) as PerceptionResults;

it("analyses all files together; a file replaces one of the same name", async () => {
  void store.add("study", [file("a"), file("b")]);
  await settled();
  program.analyses[0]?.end(named("first"));
  await settled();
  expect([store.results?.title, store.busy]).toEqual(["first", false]);
  void store.add("study", [file("b", "new"), file("c")]);
  await settled();
  expect(program.analyses[1]?.request).toEqual([file("a"), file("b", "new"), file("c")]);
  expect([store.busy, store.results?.title]).toEqual([true, "first"]);
});

it("shows the results of the newest request, also when older ones come later", async () => {
  void store.analyse("study", [file("a")]);
  await settled();
  void store.analyse("study", [file("b")]);
  await settled();
  program.analyses[0]?.end(named("old"));
  await settled();
  expect([store.results, store.busy]).toEqual([null, true]);
});

it("says why files could not be analysed, and works again without the bad file", async () => {
  void store.analyse("study", [file("a"), file("b")]);
  await settled();
  program.analyses[0]?.fail(new Error("a: expected a column"));
  await settled();
  expect([store.problem, store.results, store.busy]).toEqual(["a: expected a column", null, false]);
  void store.remove("study", "a");
  await settled();
  expect([store.problem, program.analyses[1]?.request]).toEqual(["", [file("b")]]);
  await store.remove("study", "b");
  expect([store.files, store.results, store.busy]).toEqual([[], null, false]);
});
