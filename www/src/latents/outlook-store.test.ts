import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { modelText, settled } from "../engine/engine.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
import { FUTURES, OutlookStore } from "./outlook-store";

let { engine, model, stage, notices } = new FakeLab();
let whole: FakeProgram;
let outlook: OutlookStore;
beforeEach(async () => {
  const lab = new FakeLab();
  ({ engine, model, stage, notices } = lab);
  whole = new FakeProgram();
  outlook = new OutlookStore(lab.store, model, stage, notices, whole);
  await lab.start();
});

const part = { means: new Float64Array(4), covariances: new Float64Array(8) };
const seeds = () => engine.held.filter(({ name }) => name === "futures").map(({ args }) => args.slice(1));

it("puts five futures on the stage, and removes them again", async () => {
  outlook.show("futures", true);
  await settled();
  expect([outlook.futures.length, stage.futures.length]).toEqual([FUTURES, FUTURES]);
  outlook.show("futures", false);
  expect([outlook.futures.length, stage.futures.length]).toEqual([0, 0]);
});

it("draws other futures from the next seeds, and keeps its seed under other couplings", async () => {
  engine.holding.add("futures");
  outlook.show("futures", true);
  engine.held.at(-1)?.end();
  await settled();
  outlook.drawOthers();
  engine.held.at(-1)?.end();
  await settled();
  model.couplings.set(0, 1, 2);
  await settled();
  engine.held.at(-1)?.end();
  await settled();
  expect(seeds()).toEqual([
    [FUTURES, 1],
    [FUTURES, 1 + FUTURES],
    [FUTURES, 1 + FUTURES],
  ]);
  expect(outlook.futures[0]?.request.alpha?.[0]?.[1]).toBe(2);
});

it("drops the futures of another model", async () => {
  outlook.show("futures", true);
  await settled();
  engine.holding.add("futures");
  await model.open(modelText(2));
  expect(stage.futures.length).toBe(0);
  engine.held.at(-1)?.end();
  await settled();
  expect(outlook.futures[0]?.revision).toBe(2);
});

it("asks the whole program for the moments of the rollout, with the model's document", async () => {
  outlook.show("uncertainty", true);
  await settled();
  expect(whole.moments.map(({ request }) => request)).toEqual([model.rollout?.request]);
  whole.moments[0]?.end([part, part]);
  await settled();
  expect(outlook.moments?.length).toBe(2);
  await model.open(modelText(2));
  expect(outlook.moments).toBeNull();
  await settled();
  expect(whole.outlooks).toEqual([modelText(1), modelText(2)]);
});

it("reports why there is no band, and can be asked again", async () => {
  whole.unreachable = "you are offline";
  outlook.show("uncertainty", true);
  await settled();
  expect([outlook.isShown("uncertainty"), notices.all.at(-1)?.text]).toEqual([false, "you are offline"]);
  whole.unreachable = "";
  outlook.show("uncertainty", true);
  await settled();
  expect(whole.moments.length).toBe(1);
});
