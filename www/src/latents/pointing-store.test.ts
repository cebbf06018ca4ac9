import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { modelText } from "../engine/documents.fake";
import { PointingStore } from "./pointing-store";

let { workers, stage, model } = new HeldLab();
let pointing: PointingStore;
beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, stage, model } = lab);
  pointing = new PointingStore(lab.store, model, stage);
  await lab.start();
});

const pose = (index: number) => ({ kind: "pose" as const, part: 1, index });

it("marks the poses of a point, until the visitor points at nothing", async () => {
  pointing.pointAt({ kind: "dynamics", source: 0, target: 1, index: 1 });
  await workers.settled();
  expect(stage.marks?.poses.map(({ part, opacity }) => [part, opacity])).toEqual([
    [0, 0.5],
    [1, 1],
  ]);
  expect(stage.marks?.frames).toEqual(pointing.report?.frames);
  expect(Math.max(...stage.marks!.frames)).toBeLessThanOrEqual(1);
  pointing.pointAt(pose(0));
  await workers.settled();
  expect([stage.marks?.part, stage.marks?.poses.length]).toEqual([1, 1]);
  pointing.pointAt(null);
  expect([stage.marks, pointing.report]).toEqual([null, null]);
});

it("drops the report of another point", async () => {
  workers.hold("inducing");
  pointing.pointAt(pose(0));
  await workers.settled();
  pointing.pointAt(null);
  workers.held("inducing")[0]!.go();
  await workers.settled();
  expect(stage.marks).toBeNull();
});

it("forgets its point with another model", async () => {
  workers.hold("inducing");
  pointing.pointAt(pose(0));
  await workers.settled();
  await model.open(modelText(2));
  expect(pointing.point).toBeNull();
  workers.held("inducing")[0]!.fail(new Error("there is no such point"));
  await workers.settled();
  expect([pointing.report, stage.marks]).toEqual([null, null]);
});
