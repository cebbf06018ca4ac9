import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { Recordings } from "../completing/recordings";
import { modelText } from "../engine/documents.fake";
import { loadCompleting } from "../words/sections";
import { WordsStore } from "../words/words";
import type { LiveStore } from "./live-store";
import { modelLive } from "./model-live";
import { RecordedParts } from "./recorded-parts";

let { workers, store, model, clips, notices } = new HeldLab();
let live: LiveStore;
let recorded: RecordedParts;
beforeEach(async () => {
  await loadCompleting(new WordsStore());
  const lab = new HeldLab();
  ({ workers, store, model, clips, notices } = lab);
  live = modelLive({ ...lab, engine: lab.store });
  recorded = new RecordedParts(new Recordings(lab.store, model, clips, workers), live, notices);
  await lab.start();
  await live.start();
});

it("gives a part the latents that the model infers of a recording, under the learned couplings", async () => {
  const key = recorded.all[0]?.key ?? "";
  model.couplings.set(0, 1, 9);
  recorded.choose(1, key);
  expect([recorded.keyOf(1), live.moverOf(1)]).toEqual([key, null]);
  await workers.settled();
  expect(live.moverOf(1)).toMatchObject({ kind: "record", part: 1, key });
  expect(recorded.keyOf(1)).toBe(key);
  const given = model.model?.info.parts[1]?.name;
  expect(workers.asked("complete")).toMatchObject([
    [{ given, until: null, alpha: null, reading: "as-learned" }],
  ]);
  const [step] = workers.asked("advanceLive").at(-1)!;
  const length = 2 * recorded.all[0]!.end;
  expect(step.changes.at(-1)).toMatchObject({ kind: "record", part: 1, latents: { length } });
  live.release(1);
  expect(recorded.keyOf(1)).toBeNull();
});

it("does not take a recording that is no longer wanted", async () => {
  recorded.choose(0, recorded.all[0]?.key ?? "");
  recorded.choose(0, null);
  await workers.settled();
  expect([workers.asked("complete").length, live.moverOf(0), recorded.keyOf(0)]).toEqual([1, null, null]);
});

it("says why a recording is refused, and leaves the part to the model", async () => {
  const bvh = await store.engine!.rolloutBvh(model.rolloutRequest());
  const key = await clips.addModelled("tall", bvh.replace(/OFFSET .*/g, "OFFSET 0 20 0"));
  recorded.choose(0, key);
  await workers.settled();
  expect([recorded.keyOf(0), live.moverOf(0)]).toEqual([null, null]);
  expect(notices.all.at(-1)?.text).toMatch(/^tall is not of the body of the model/);
});

it("gives each of several parts its recording, also when they are chosen at once", async () => {
  const key = recorded.all[0]?.key ?? "";
  for (const part of [0, 1]) recorded.choose(part, key);
  recorded.choose(0, null);
  recorded.choose(0, key);
  await workers.settled();
  expect([0, 1].map((part) => live.moverOf(part)?.kind)).toEqual(["record", "record"]);
});

it("waits no longer for the recording of an old model", async () => {
  recorded.choose(0, recorded.all[0]?.key ?? "");
  await model.open(modelText(2));
  void live.start();
  await workers.settled();
  expect([recorded.keyOf(0), live.moverOf(0)]).toEqual([null, null]);
});
