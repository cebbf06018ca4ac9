import { beforeEach, expect, it } from "vitest";
import { FakeEngine, MOVES_ON, modelText, STANDS_STILL, settled, started } from "../engine/engine.fake";
import { EngineStore } from "../engine/engine-store";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { HealthStore } from "./health-store";
import { ModelStore } from "./model-store";

let engine: FakeEngine;
let model: ModelStore;
let health: HealthStore;
beforeEach(async () => {
  engine = new FakeEngine();
  const store = new EngineStore();
  const settings = new SettingsStore(new FakeAddressBar());
  model = new ModelStore(store, settings, new StageStore(new Playback(settings)), new NoticesStore());
  health = new HealthStore(store, model, 0);
  await store.start(
    () => Promise.resolve(started(engine)),
    () => Promise.resolve(),
  );
});

/** Lets what waits for its turn happen, and what that leads to. */
const calm = async () => {
  for (let i = 0; i < 4; i++) await settled();
};

it("says how each rollout that comes to the stage ends", async () => {
  engine.health = STANDS_STILL;
  await model.open(modelText(1));
  expect(health.health).toBeNull();
  await calm();
  expect(health.health).toEqual(STANDS_STILL);
  engine.health = MOVES_ON;
  model.setCoupling(0, 1, 3);
  await settled();
  await calm();
  expect(health.health).toEqual(MOVES_ON);
});

it("forgets an answer about a rollout that is no longer there", async () => {
  engine.health = STANDS_STILL;
  engine.holding.add("bodyReport");
  await model.open(modelText(1));
  await calm();
  engine.holding.delete("bodyReport");
  engine.health = MOVES_ON;
  await model.open(modelText(2));
  engine.held[0]?.end();
  await calm();
  expect(health.health).toEqual(MOVES_ON);
});
