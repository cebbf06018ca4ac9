import { beforeEach, expect, it } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { AnalysisStore } from "./analysis-store";
import { answersText, studyText } from "./study.fake";

let workers: HeldWorkers;
let store: AnalysisStore;
beforeEach(() => {
  workers = new HeldWorkers();
  workers.hold("analysePerception");
  store = new AnalysisStore(workers);
});

const STUDY = studyText("walks");
const file = (name: string, text = answersText(name, "left", "right")) => ({ name, text });
const named = () => store.results?.participants.map(({ name, comparisons }) => [name, comparisons]);
/** Lets an analysis go, and waits for what the store does then. */
async function go(place: number): Promise<void> {
  workers.held("analysePerception")[place]?.go();
  await workers.settled();
}

it("analyses all files together; a file replaces one of the same name", async () => {
  void store.add(STUDY, [file("a"), file("b")]);
  await workers.settled();
  await go(0);
  const first = [
    ["a", 2],
    ["b", 2],
  ];
  expect([named(), store.busy]).toEqual([first, false]);
  void store.add(STUDY, [file("b", answersText("b", "left")), file("c")]);
  await workers.settled();
  expect([store.busy, named()]).toEqual([true, first]);
  await go(1);
  expect([named(), store.busy]).toEqual([[first[0], ["b", 1], ["c", 2]], false]);
});

it("shows the results of the newest request, also when older ones come later", async () => {
  void store.analyse(STUDY, [file("a")]);
  await workers.settled();
  void store.analyse(STUDY, [file("b")]);
  await workers.settled();
  await go(0);
  expect([store.results, store.busy]).toEqual([null, true]);
  await go(1);
  expect([named(), store.busy]).toEqual([[["b", 2]], false]);
});

it("says why files could not be analysed, and works again without the bad file", async () => {
  workers.letGo("analysePerception");
  await store.analyse(STUDY, [file("a", "hello"), file("b")]);
  expect([store.results, store.busy]).toEqual([null, false]);
  expect(store.problem).toMatch(/^a: expected a column/);
  await store.remove(STUDY, "a");
  expect([store.problem, named()]).toEqual(["", [["b", 2]]]);
  await store.remove(STUDY, "b");
  expect([store.files, store.results, store.busy]).toEqual([[], null, false]);
});
