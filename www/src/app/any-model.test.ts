import { beforeEach, expect, it, vi } from "vitest";
import { documentText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import type { HandlesView } from "../live/handles-view";
import { NoticesStore } from "../ui/notices-store";
import { WordsStore } from "../words/words";
import { otherModelOnStage, showAnyModel } from "./any-model";

const words = new WordsStore();
const notices = new NoticesStore();
let settings: SettingsStore;
let playback: Playback;
let stage: StageStore;
let workers: HeldWorkers;
beforeEach(async () => {
  const documentElement = { lang: "" };
  Object.assign(globalThis, { document: { documentElement, createElement: () => ({}) } });
  await words.load("en");
  settings = new SettingsStore(new FakeAddressBar("frames=120"));
  playback = new Playback(settings);
  stage = new StageStore(playback);
  workers = new HeldWorkers();
});

const page = () => ({ stage, playback, settings, notices, words, workers });

const TMP = documentText("tmp");
const DMP = documentText("dmp-discrete");
const show = (name: string, text: string) => showAnyModel(page(), { name, text, link: null });

/** The motion of a model with couplings. */
function showModel(): void {
  const { figure, joints, parts, motion } = {
    ...{ figure: { nodes: [] }, joints: [], parts: [] },
    motion: { positions: new Float32Array(), frames: 2, nodes: 0, frameTime: 0.1 },
  };
  stage.showModel({ kind: "model", figure, joints, parts, motion });
}

it("shows the motion of a model without couplings, as long as that of the model, and says so", async () => {
  await show("walk.model.json", TMP);
  const made = await workers.desk.run((worker) => worker.rollOutAny(TMP, 120));
  expect(stage.content).toMatchObject({
    kind: "clip",
    joints: made.joints.map(({ name }) => name),
    motion: made.motion,
    caption: { title: "Made by a TMP", text: expect.stringContaining("change its tempo") },
  });
  const named = { name: "walk", text: TMP, modelFile: "" };
  expect(otherModelOnStage(stage)).toMatchObject({ ...named, kind: "tmp", bvh: made.bvh });
});

it("has the handles of a TMP or DMP, whose motion has the learned one as its outline", async () => {
  workers.answer("rollOutAny", async (real, ...given) => ({ ...(await real(...given)), kind: "map-gpdm" }));
  await show("a.json", TMP);
  expect(stage.content?.controls).toBe(undefined);
  workers.answer("rollOutAny", (real, ...given) => real(...given));
  await show("a.json", DMP);
  const learned = stage.content?.motion;
  const { handles } = stage.content!.controls as HandlesView;
  handles.tempo = 2;
  await vi.waitFor(() => expect(stage.content?.ghost).toBe(learned));
  expect(stage.content?.motion).not.toEqual(learned);
  expect(otherModelOnStage(stage)).toMatchObject({ name: "a", handles: { tempo: 2 }, text: DMP });
  showModel();
  stage.endClip();
  expect(handles.running).toBe(false);
});

it("goes when the model comes back", async () => {
  showModel();
  await show("a.json", documentText("dmp-rhythmic"));
  expect(stage.content?.caption?.title).toBe("Made by a DMP (rhythmic)");
  stage.endClip();
  expect([stage.content?.kind, otherModelOnStage(stage)]).toEqual(["model", null]);
});

it("is named by the address that brought it until it leaves the stage", async () => {
  showModel();
  const link = { frames: 60, take: () => settings.change({ modelFile: "b.json", frames: 60 }) };
  await showAnyModel(page(), { name: "b.json", text: TMP, link });
  expect(otherModelOnStage(stage)).toMatchObject({ motion: { frames: 60 }, modelFile: "b.json" });
  showModel();
  expect(settings.values.modelFile).toBe("b.json");
  stage.endClip();
  expect(settings.values).toMatchObject({ modelFile: "", frames: 60 });
});

it("changes nothing when the document cannot be read", async () => {
  await expect(show("a.json", "no model")).rejects.toThrow("expected a model as JSON");
  expect(stage.content).toBe(null);
});
