import { beforeEach, expect, it } from "vitest";
import { ClipsStore } from "../clips/clips-store";
import { Recordings } from "../completing/recordings";
import { ModelStore } from "../couplings/model-store";
import { FakeEngine, modelText, settled, started } from "../engine/engine.fake";
import { EngineStore } from "../engine/engine-store";
import { FakeProgram } from "../engine/whole-workers.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { loadCompleting } from "../words/sections";
import { WordsStore } from "../words/words";
import type { LiveStore } from "./live-store";
import { modelLive } from "./model-live";
import { RecordedParts } from "./recorded-parts";

let model: ModelStore;
let notices: NoticesStore;
let whole: FakeProgram;
let live: LiveStore;
let recorded: RecordedParts;
beforeEach(async () => {
  await loadCompleting(new WordsStore());
  whole = new FakeProgram();
  notices = new NoticesStore();
  const settings = new SettingsStore(new FakeAddressBar());
  const store = new EngineStore();
  const playback = new Playback(settings);
  const stage = new StageStore(playback);
  model = new ModelStore(store, settings, stage, notices);
  live = modelLive({ engine: store, model, stage, playback, notices });
  const recordings = new Recordings(store, model, new ClipsStore(store, settings, stage), whole);
  recorded = new RecordedParts(recordings, live, notices);
  await store.start(
    () => Promise.resolve(started(new FakeEngine())),
    () => model.open(modelText(1)),
  );
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
  expect([recorded.keyOf(0), live.moverOf(0), notices.all.at(-1)?.text]).toEqual([
    null,
    null,
    "the body differs",
  ]);
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
