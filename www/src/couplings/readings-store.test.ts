import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "./lab.fake";
import { modelText } from "../engine/documents.fake";
import { LiveTrack } from "../scene/live-track";
import { ReadingsStore } from "./readings-store";

let { workers, model, stage } = new HeldLab();
let readings: ReadingsStore;

beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, model, stage } = lab);
  readings = new ReadingsStore(lab.store, model, stage);
  await lab.start();
});

const titles = () => stage.columns?.map(({ title }) => title);

it("shows the same couplings in both readings, as learned on the left whichever is chosen", async () => {
  model.couplings.set(0, 1, 8);
  await workers.settled();
  readings.show(true);
  await workers.settled();
  expect(titles()).toEqual(["Experts as learned", "Experts re-inferred"]);
  expect(
    workers
      .asked("rollout")
      .slice(-2)
      .map(([{ reading, alpha }]) => [reading, alpha?.[0]?.[1]]),
  ).toEqual([
    ["re-inferred", 8],
    ["as-learned", 8],
  ]);
  expect(stage.columns?.[1]?.motion).toBe(model.rollout?.motion);
  model.couplings.setReading("as-learned");
  await workers.settled();
  expect(stage.columns?.[0]?.motion).toBe(model.rollout?.motion);
  expect(stage.columns?.[1]?.motion.positions).not.toEqual(model.rollout?.motion.positions);
});

it("follows the couplings, and never shows a pair with different couplings", async () => {
  readings.show(true);
  expect(stage.columns?.map(({ motion }) => motion)).toEqual([model.learned?.motion, model.learned?.motion]);
  model.couplings.set(0, 1, 8);
  await workers.settled();
  workers.hold("rollout");
  const before = stage.columns;
  model.couplings.set(0, 1, 9);
  await workers.settled();
  const go = async (first: number, end: number) => {
    for (const call of workers.held("rollout").slice(first, end)) call.go();
    await workers.settled();
  };
  await go(0, 1);
  // The coupling changes to 10 after the motion under 9, and before its other reading.
  model.couplings.set(0, 1, 10);
  await workers.settled();
  expect(
    workers.held("rollout").map(({ given: [{ reading, alpha }] }) => [reading, alpha?.[0]?.[1]]),
  ).toEqual([
    ["re-inferred", 9],
    ["as-learned", 9],
    ["re-inferred", 10],
  ]);
  await go(1, 3);
  expect(stage.columns).toBe(before);
  await go(3, 4);
  expect(stage.columns).not.toBe(before);
  expect(model.rollout?.request.alpha?.[0]?.[1]).toBe(10);
  expect(stage.columns?.some(({ motion }) => motion === model.rollout?.motion)).toBe(true);
});

it("hides both figures on request, and while a clip is in front", async () => {
  model.couplings.set(0, 1, 8);
  readings.show(true);
  await workers.settled();
  stage.showClip({ ...stage.content!, kind: "clip", clip: "a" });
  expect(stage.columns).toBeNull();
  stage.endClip();
  expect(titles()).toHaveLength(2);
  readings.show(false);
  expect([readings.bothShown, stage.columns]).toEqual([false, null]);
  model.couplings.set(0, 1, 9);
  await workers.settled();
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
  await workers.settled();
  workers.hold("rollout");
  readings.show(true);
  await workers.settled();
  workers.held("rollout")[0]!.fail(new Error("not positive definite"));
  await workers.settled();
  expect([readings.bothShown, stage.columns]).toEqual([false, null]);
});

it("shows no figures of a model that was replaced", async () => {
  model.couplings.set(0, 1, 8);
  readings.show(true);
  await workers.settled();
  workers.hold("rollout");
  await model.open(modelText(2), { couplings: "visitor", clip: false });
  expect(stage.columns?.every(({ motion }) => motion === model.rollout?.motion) ?? true).toBe(true);
});
