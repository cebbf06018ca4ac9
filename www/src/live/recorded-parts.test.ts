import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { Recordings } from "../completing/recordings";
import { modelText, settled } from "../engine/engine.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
import { loadCompleting } from "../words/sections";
import { WordsStore } from "../words/words";
import type { LiveStore } from "./live-store";
import { modelLive } from "./model-live";
import { RecordedParts } from "./recorded-parts";

let { model, notices } = new FakeLab();
let whole: FakeProgram;
let live: LiveStore;
let recorded: RecordedParts;
beforeEach(async () => {
  await loadCompleting(new WordsStore());
  whole = new FakeProgram();
  const lab = new FakeLab();
  ({ model, notices } = lab);
  live = modelLive({ ...lab, engine: lab.store });
  recorded = new RecordedParts(new Recordings(lab.store, model, lab.clips, whole), live, notices);
  await lab.start();
  await live.start();
});

/** Waits for the model's own walk as a file, the worker and its answer. */
async function answered() {
  for (let k = 0; k < 5; k++) await settled();
}

it("gives a part the latents that the model infers of a recording, under the learned couplings", async () => {
  const key = recorded.all[0]?.key ?? "";
  model.couplings.set(0, 1, 9);
  recorded.choose(1, key);
  expect([recorded.keyOf(1), live.moverOf(1)]).toEqual([key, null]);
  await answered();
  expect(live.moverOf(1)).toMatchObject({ kind: "record", part: 1, key });
  expect(recorded.keyOf(1)).toBe(key);
  const given = model.model?.info.parts[1]?.name;
  expect(whole.completions).toMatchObject([{ given, until: null, alpha: null, reading: "as-learned" }]);
  live.release(1);
  expect(recorded.keyOf(1)).toBeNull();
});

it("does not take a recording that is no longer wanted", async () => {
  recorded.choose(0, recorded.all[0]?.key ?? "");
  recorded.choose(0, null);
  await answered();
  expect([whole.completions.length, live.moverOf(0), recorded.keyOf(0)]).toEqual([1, null, null]);
});

it("says why a recording is refused, and leaves the part to the model", async () => {
  whole.failures.push(new Error("the body differs"));
  recorded.choose(0, recorded.all[0]?.key ?? "");
  await answered();
  const found = [recorded.keyOf(0), live.moverOf(0), notices.all.at(-1)?.text];
  expect(found).toEqual([null, null, "the body differs"]);
});

it("gives each of several parts its recording, also when they are chosen at once", async () => {
  const key = recorded.all[0]?.key ?? "";
  for (const part of [0, 1]) recorded.choose(part, key);
  recorded.choose(0, null);
  recorded.choose(0, key);
  await answered();
  expect([0, 1].map((part) => live.moverOf(part)?.kind)).toEqual(["record", "record"]);
});

it("waits no longer for the recording of an old model", async () => {
  recorded.choose(0, recorded.all[0]?.key ?? "");
  await model.open(modelText(2));
  void live.start();
  await answered();
  expect([recorded.keyOf(0), live.moverOf(0)]).toEqual([null, null]);
});
