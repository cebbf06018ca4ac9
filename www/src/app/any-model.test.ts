import { beforeEach, expect, it } from "vitest";
import { FakeProgram } from "../engine/whole-workers.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { otherModelOnStage, showAnyModel } from "./any-model";

let settings: SettingsStore;
let stage: StageStore;
let program: FakeProgram;
beforeEach(() => {
  settings = new SettingsStore(new FakeAddressBar("frames=120"));
  stage = new StageStore(new Playback(settings));
  program = new FakeProgram();
});

const show = (name: string, text: string) =>
  showAnyModel({ stage, settings, workers: program }, { name, text, link: null });

/** The motion of a model with couplings. */
function showModel(): void {
  const { figure, joints, parts, motion } = {
    ...{ figure: { nodes: [] }, joints: [], parts: [] },
    motion: { positions: new Float32Array(), frames: 2, nodes: 0, frameTime: 0.1 },
  };
  stage.showModel({ kind: "model", figure, joints, parts, motion });
}

it("shows the motion of a model without couplings, as long as that of the model, and says so", async () => {
  await show("walk.model.json", '{"kind":"tmp"}');
  expect(stage.content).toMatchObject({
    kind: "clip",
    joints: ["hips"],
    motion: { frames: 120 },
    caption: { title: "Made by a TMP", text: expect.stringContaining("without couplings") },
  });
  expect(otherModelOnStage(stage)).toMatchObject({
    ...{ name: "walk", kind: "tmp", bvh: "HIERARCHY" },
    ...{ text: '{"kind":"tmp"}', modelFile: "" },
  });
});

it("goes when the model comes back", async () => {
  showModel();
  await show("a.json", '{"kind":"dmp-rhythmic"}');
  expect(stage.content?.caption?.title).toBe("Made by a DMP (rhythmic)");
  stage.endClip();
  expect([stage.content?.kind, otherModelOnStage(stage)]).toEqual(["model", null]);
});

it("is named by the address that brought it until it leaves the stage", async () => {
  showModel();
  const link = { frames: 60, take: () => settings.change({ modelFile: "b.json", frames: 60 }) };
  await showAnyModel({ stage, settings, workers: program }, { name: "b.json", text: '{"kind":"tmp"}', link });
  expect(otherModelOnStage(stage)).toMatchObject({ motion: { frames: 60 }, modelFile: "b.json" });
  showModel();
  expect(settings.values.modelFile).toBe("b.json");
  stage.endClip();
  expect(settings.values).toMatchObject({ modelFile: "", frames: 60 });
});

it("changes nothing when the document cannot be read", async () => {
  await expect(show("a.json", "no model")).rejects.toThrow();
  expect(stage.content).toBe(null);
});
