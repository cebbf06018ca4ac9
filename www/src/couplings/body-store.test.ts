import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { HeldLab } from "./lab.fake";
import { modelText } from "../engine/documents.fake";
import { BodyStore } from "./body-store";

let { workers, model } = new HeldLab();
let body: BodyStore;

beforeEach(async () => {
  vi.useFakeTimers();
  const lab = new HeldLab();
  ({ workers, model } = lab);
  body = new BodyStore(lab.store, model);
  await lab.start(modelText(1, 1, 30));
});
afterEach(() => vi.useRealTimers());

const asked = () => workers.asked("bodyReport");
const pause = () => vi.advanceTimersByTimeAsync(200);

it("measures 20 seconds, without the first 5, of the motion and of the motion as learned", async () => {
  await pause();
  expect(asked()).toEqual([[{ frames: 600, sequence: 0, alpha: null, reading: "as-learned" }, 150]]);
  expect([body.reports?.now, body.isCurrent]).toEqual([body.reports?.learned, true]);
  model.couplings.set(0, 1, 8);
  expect(body.isCurrent).toBe(false);
  await pause();
  expect(body.isCurrent).toBe(true);
  expect(body.reports?.now.request.alpha?.[0]?.[1]).toBe(8);
  // The motion as learned was measured before.
  expect(asked().length).toBe(2);
  model.setSeconds(30);
  await pause();
  expect(body.reports?.learned.request.frames).toBe(900);
});

it("waits until the slider rests, and marks the measures of an older motion", async () => {
  await pause();
  const before = asked().length;
  for (let i = 1; i <= 10; i++) {
    model.couplings.set(0, 1, 8 + i);
    await vi.advanceTimersByTimeAsync(50);
    expect([asked().length - before, body.isCurrent]).toEqual([0, false]);
  }
  await pause();
  expect([asked().length - before, body.isCurrent]).toEqual([1, true]);
});

it("drops the measures of a model that was replaced", async () => {
  workers.hold("bodyReport");
  await pause();
  workers.letGo("bodyReport");
  const end = await workers.held("bodyReport")[0]!.late();
  await model.open(modelText(2));
  end();
  await vi.advanceTimersByTimeAsync(10);
  expect(body.reports).toBeNull();
  await pause();
  expect(body.reports?.now.revision).toBe(2);
});
