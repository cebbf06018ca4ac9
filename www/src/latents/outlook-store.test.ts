import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { modelText } from "../engine/documents.fake";
import { FUTURES, OutlookStore } from "./outlook-store";

let { workers, model, stage, notices } = new HeldLab();
let outlook: OutlookStore;
beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, model, stage, notices } = lab);
  outlook = new OutlookStore(lab.store, model, stage, notices, workers);
  await lab.start();
});

it("puts five futures on the stage, and removes them again", async () => {
  outlook.show("futures", true);
  await workers.settled();
  expect(new Set(stage.futures.map(({ positions }) => positions.join())).size).toBe(FUTURES);
  expect(stage.futures).toEqual(outlook.futures.map(({ motion }) => motion));
  outlook.show("futures", false);
  expect([outlook.futures.length, stage.futures.length]).toEqual([0, 0]);
});

it("draws other futures from the next seeds, and keeps its seed under other couplings", async () => {
  outlook.show("futures", true);
  await workers.settled();
  outlook.drawOthers();
  await workers.settled();
  model.couplings.set(0, 1, 2);
  await workers.settled();
  expect(workers.asked("futures").map(([_, count, seed]) => [count, seed])).toEqual([
    [FUTURES, 1],
    [FUTURES, 1 + FUTURES],
    [FUTURES, 1 + FUTURES],
  ]);
  expect(outlook.futures[0]?.request.alpha?.[0]?.[1]).toBe(2);
});

it("drops the futures of another model", async () => {
  outlook.show("futures", true);
  await workers.settled();
  workers.hold("futures");
  model.couplings.set(0, 1, 2);
  await workers.settled();
  const [before] = workers.held("futures");
  const end = await before!.late();
  await model.open(modelText(2));
  expect(stage.futures.length).toBe(0);
  end();
  await workers.settled();
  expect(stage.futures.length).toBe(0);
  workers.held("futures")[1]!.go();
  await workers.settled();
  expect(outlook.futures[0]?.revision).toBe(2);
});

it("asks the whole program for the moments of the rollout, with the model's document", async () => {
  outlook.show("uncertainty", true);
  await workers.settled();
  expect(workers.asked("moments")).toEqual([[model.rollout?.request]]);
  const { frames } = model.rollout!.motion;
  expect(outlook.moments?.map(({ means }) => means.length)).toEqual([2 * frames, 2 * frames]);
  await model.open(modelText(2));
  expect(outlook.moments).toBeNull();
  await workers.settled();
  const documents = workers.asked("openOutlook").map(([text]) => JSON.parse(text) as unknown);
  expect(documents).toEqual([1, 2].map((seed) => JSON.parse(modelText(seed)) as unknown));
});

it("reports why there is no band, and can be asked again", async () => {
  workers.unreachable = "you are offline";
  outlook.show("uncertainty", true);
  await workers.settled();
  expect([outlook.isShown("uncertainty"), notices.all.at(-1)?.text]).toEqual([false, "you are offline"]);
  workers.unreachable = "";
  outlook.show("uncertainty", true);
  await workers.settled();
  expect(outlook.moments?.length).toBe(2);
});
