import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { modelText, settled } from "../engine/engine.fake";
import { PointingStore } from "./pointing-store";

let { engine, stage, model } = new FakeLab();
let pointing: PointingStore;
beforeEach(async () => {
  const lab = new FakeLab();
  ({ engine, stage, model } = lab);
  pointing = new PointingStore(lab.store, model, stage);
  await lab.start();
});

const pose = (index: number) => ({ kind: "pose" as const, part: 1, index });

it("marks the poses of a point, until the visitor points at nothing", async () => {
  pointing.pointAt({ kind: "dynamics", source: 0, target: 1, index: 2 });
  await settled();
  expect(stage.marks?.poses.map(({ part, opacity }) => [part, opacity])).toEqual([
    [0, 0.5],
    [1, 1],
  ]);
  pointing.pointAt(pose(0));
  await settled();
  expect([stage.marks?.part, stage.marks?.poses.length]).toEqual([1, 1]);
  pointing.pointAt(null);
  expect([stage.marks, pointing.report]).toEqual([null, null]);
});

it("drops the report of another point", async () => {
  engine.holding.add("inducing");
  pointing.pointAt(pose(0));
  pointing.pointAt(null);
  engine.held[0]?.end();
  await settled();
  expect(stage.marks).toBeNull();
});

it("forgets its point with another model", async () => {
  engine.holding.add("inducing");
  pointing.pointAt(pose(0));
  await model.open(modelText(2));
  expect(pointing.point).toBeNull();
  engine.held[0]?.fail(new Error("there is no such point"));
  await settled();
  expect([pointing.report, stage.marks]).toEqual([null, null]);
});
