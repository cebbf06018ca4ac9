import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "./lab.fake";
import { modelText, settled } from "../engine/engine.fake";
import { LiveTrack } from "../scene/live-track";
import { ReadingsStore } from "./readings-store";

let { engine, model, stage } = new FakeLab();
let readings: ReadingsStore;

beforeEach(async () => {
  const lab = new FakeLab();
  ({ engine, model, stage } = lab);
  readings = new ReadingsStore(lab.store, model, stage);
  await lab.start();
});

const titles = () => stage.columns?.map(({ title }) => title);

it("shows the same couplings in both readings, as learned on the left whichever is chosen", async () => {
  model.couplings.set(0, 1, 8);
  await settled();
  readings.show(true);
  await settled();
  expect(titles()).toEqual(["Experts as learned", "Experts re-inferred"]);
  expect(engine.rollouts.slice(-2).map(({ reading, alpha }) => [reading, alpha?.[0]?.[1]])).toEqual([
    ["re-inferred", 8],
    ["as-learned", 8],
  ]);
  expect(stage.columns?.[1]?.motion).toBe(model.rollout?.motion);
  model.couplings.setReading("as-learned");
  await settled();
  expect(stage.columns?.[0]?.motion).toBe(model.rollout?.motion);
  expect(stage.columns?.[1]?.motion).not.toBe(model.rollout?.motion);
});

it("follows the couplings, and never shows a pair with different couplings", async () => {
  readings.show(true);
  expect(stage.columns?.map(({ motion }) => motion)).toEqual([model.learned?.motion, model.learned?.motion]);
  model.couplings.set(0, 1, 8);
  await settled();
  engine.holding.add("rollout");
  engine.held.length = 0;
  const before = stage.columns;
  model.couplings.set(0, 1, 9);
  engine.held[0]?.end();
  await settled();
  // The coupling changes to 10 after the motion under 9, and before its other reading.
  model.couplings.set(0, 1, 10);
  for (const call of engine.held.slice(1)) call.end();
  await settled();
  for (const call of engine.held.slice(3)) call.end();
  await settled();
  expect(stage.columns).not.toBe(before);
  expect(model.rollout?.request.alpha?.[0]?.[1]).toBe(10);
  expect(stage.columns?.some(({ motion }) => motion === model.rollout?.motion)).toBe(true);
});

it("hides both figures on request, and while a clip is in front", async () => {
  model.couplings.set(0, 1, 8);
  readings.show(true);
  await settled();
  stage.showClip({ ...stage.content!, kind: "clip", clip: "a" });
  expect(stage.columns).toBeNull();
  stage.endClip();
  expect(titles()).toHaveLength(2);
  readings.show(false);
  expect([readings.bothShown, stage.columns]).toEqual([false, null]);
  model.couplings.set(0, 1, 9);
  await settled();
  expect(stage.columns).toBeNull();
});

it("ends when a live motion begins, and ends a live motion when it begins", async () => {
  readings.show(true);
  stage.showLive(new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 60));
  expect([readings.bothShown, stage.columns]).toEqual([false, null]);
  readings.show(true);
  expect([stage.content?.live, titles()?.length]).toEqual([undefined, 2]);
});

it("keeps one figure where the other reading fails", async () => {
  model.couplings.set(0, 1, 8);
  await settled();
  engine.holding.add("rollout");
  readings.show(true);
  engine.held[0]?.fail(new Error("not positive definite"));
  await settled();
  expect([readings.bothShown, stage.columns]).toEqual([false, null]);
});

it("shows no figures of a model that was replaced", async () => {
  model.couplings.set(0, 1, 8);
  readings.show(true);
  await settled();
  engine.holding.add("rollout");
  await model.open(modelText(2), { couplings: "visitor", clip: false });
  expect(stage.columns?.every(({ motion }) => motion === model.rollout?.motion) ?? true).toBe(true);
});
