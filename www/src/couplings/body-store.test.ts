import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeEngine, modelText, started } from "../engine/engine.fake";
import { EngineStore } from "../engine/engine-store";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { BodyStore } from "./body-store";
import { ModelStore } from "./model-store";

let engine: FakeEngine;
let model: ModelStore;
let body: BodyStore;

beforeEach(async () => {
  vi.useFakeTimers();
  engine = new FakeEngine();
  const store = new EngineStore();
  const settings = new SettingsStore(new FakeAddressBar());
  model = new ModelStore(store, settings, new StageStore(new Playback(settings)), new NoticesStore());
  body = new BodyStore(store, model);
  await store.start(
    () => Promise.resolve(started(engine)),
    () => model.open(modelText(1)),
  );
});
afterEach(() => vi.useRealTimers());

const pause = () => vi.advanceTimersByTimeAsync(200);

it("measures 20 seconds, without the first 5, of the motion and of the motion as learned", async () => {
  const asked = vi.spyOn(engine, "bodyReport");
  await pause();
  expect(asked.mock.calls).toEqual([[{ frames: 600, sequence: 0, alpha: null, reading: "as-learned" }, 150]]);
  expect([body.reports?.now, body.isCurrent]).toEqual([body.reports?.learned, true]);
  model.couplings.set(0, 1, 8);
  expect(body.isCurrent).toBe(false);
  await pause();
  expect(body.isCurrent).toBe(true);
  expect(body.reports?.now.request.alpha?.[0]?.[1]).toBe(8);
  // The motion as learned was measured before.
  expect(asked).toHaveBeenCalledTimes(2);
  model.setSeconds(30);
  await pause();
  expect(body.reports?.learned.request.frames).toBe(900);
});

it("waits until the slider rests, and marks the measures of an older motion", async () => {
  await pause();
  const asked = vi.spyOn(engine, "bodyReport");
  for (let i = 1; i <= 10; i++) {
    model.couplings.set(0, 1, 8 + i);
    await vi.advanceTimersByTimeAsync(50);
    expect([asked.mock.calls.length, body.isCurrent]).toEqual([0, false]);
  }
  await pause();
  expect([asked.mock.calls.length, body.isCurrent]).toEqual([1, true]);
});

it("drops the measures of a model that was replaced", async () => {
  engine.holding.add("bodyReport");
  await pause();
  engine.holding.clear();
  await model.open(modelText(2));
  engine.held[0]?.end();
  await vi.advanceTimersByTimeAsync(10);
  expect(body.reports).toBeNull();
  await pause();
  expect(body.reports?.now.revision).toBe(2);
});
