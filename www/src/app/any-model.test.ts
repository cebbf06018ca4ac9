import { beforeEach, expect, it } from "vitest";
import { FakeProgram } from "../engine/whole-workers.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { motionOnStage, showAnyModel } from "./any-model";

let settings: SettingsStore;
let stage: StageStore;
let program: FakeProgram;
beforeEach(() => {
  settings = new SettingsStore(new FakeAddressBar("frames=120"));
  stage = new StageStore(new Playback(settings));
  program = new FakeProgram();
});

it("shows the motion of a model without couplings, as long as that of the model, and says so", async () => {
  await showAnyModel({ stage, settings }, "walk.model.json", '{"kind":"tmp"}', program);
  expect(stage.content).toMatchObject({
    kind: "clip",
    joints: ["hips"],
    motion: { frames: 120 },
    caption: { title: "Made by a TMP", text: expect.stringContaining("without couplings") },
  });
  expect(motionOnStage(stage)).toMatchObject({
    name: "walk",
    kind: "tmp",
    bvh: "HIERARCHY",
    text: '{"kind":"tmp"}',
  });
});

it("goes when the model comes back", async () => {
  const { figure, joints, parts, motion } = {
    ...{ figure: { nodes: [] }, joints: [], parts: [] },
    motion: { positions: new Float32Array(), frames: 2, nodes: 0, frameTime: 0.1 },
  };
  stage.showModel({ kind: "model", figure, joints, parts, motion });
  await showAnyModel({ stage, settings }, "a.json", '{"kind":"dmp-rhythmic"}', program);
  expect(stage.content?.caption?.title).toBe("Made by a DMP (rhythmic)");
  stage.endClip();
  expect([stage.content?.kind, motionOnStage(stage)]).toEqual(["model", null]);
});

it("changes nothing when the document cannot be read", async () => {
  await expect(showAnyModel({ stage, settings }, "a.json", "no model", program)).rejects.toThrow();
  expect(stage.content).toBe(null);
});
