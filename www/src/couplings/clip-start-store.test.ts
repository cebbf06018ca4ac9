import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "./lab.fake";
import { modelText, settled } from "../engine/engine.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
import { ClipStartStore } from "./clip-start-store";

let { model, clips, notices, settings } = new FakeLab();
let whole: FakeProgram;
let starts: ClipStartStore;
beforeEach(async () => {
  const lab = new FakeLab();
  ({ model, clips, notices, settings } = lab);
  whole = new FakeProgram();
  starts = new ClipStartStore(lab.store, model, clips, notices, whole);
  await lab.start(modelText(1, 2));
  await clips.loadSamples();
});

/** Latents of two parts in two frames. */
const latents = [
  [
    [1, 2],
    [3, 4],
  ],
  [
    [5, 6],
    [7, 8],
  ],
];

/** Chooses a clip, and lets the worker infer its start. */
async function choose(key: string): Promise<void> {
  starts.chooseClip(key);
  await settled();
  whole.starts.at(-1)?.end(latents);
  await settled();
}

it("starts the rollouts, and the outline, with the first half second of a clip", async () => {
  expect(starts.clips.map(({ title }) => title)).toEqual(["walk-1", "walk-2", "wave-1"]);
  model.setStart(1, 3);
  await choose("made-wave-1");
  expect(whole.starts[0]?.request).toMatchObject({
    text: modelText(1, 2),
    clip: { source: { sample: "wave-1" }, first: 0, end: 60 },
    frames: 15,
  });
  expect([starts.clip, starts.observed, model.rollout?.request]).toEqual([
    "made-wave-1",
    0.5,
    { frames: 300, sequence: 0, start: latents, alpha: null, reading: "as-learned" },
  ]);
  expect([settings.values.start, settings.values.startFrame]).toEqual([0, 0]);

  model.couplings.set(0, 1, 20);
  await settled();
  expect(model.rollout?.request).toMatchObject({ start: latents, reading: "re-inferred" });
  expect(model.learned?.request).toMatchObject({ start: latents, alpha: null });

  starts.chooseSequence(1);
  await settled();
  const found = [starts.clip, model.rollout?.request.sequence, model.rollout?.request.start];
  expect(found).toEqual([null, 1, undefined]);
});

it("leaves out clips that the model was trained on, and keeps a start whose clip was removed", async () => {
  const keys = () => starts.clips.map(({ key }) => key);
  clips.all[0]!.loaded.info.sha256 = model.model!.info.sequences[1]!.sha256;
  expect(keys()).toEqual(["made-walk-2", "made-wave-1"]);
  await choose("made-walk-2");
  await clips.remove("made-walk-2");
  expect(keys()).toEqual(["made-wave-1", "made-walk-2"]);
});

it("drops a start that arrives after another choice or another model", async () => {
  starts.chooseClip("made-wave-1");
  await settled();
  expect([starts.clip, starts.isBusy]).toEqual(["made-wave-1", true]);
  starts.chooseSequence(1);
  whole.starts.at(-1)?.end(latents);
  await settled();
  expect([starts.clip, starts.isBusy, model.clipStart]).toEqual([null, false, null]);

  starts.chooseClip("made-wave-1");
  await settled();
  await model.open(modelText(2));
  whole.starts.at(-1)?.end(latents);
  await settled();
  expect([starts.clip, model.clipStart]).toEqual([null, null]);

  // Another model starts as its own first sequence again.
  await choose("made-wave-1");
  expect(model.clipStart?.key).toBe("made-wave-1");
  await model.open(modelText(3));
  expect([starts.clip, model.rollout?.request.start]).toEqual([null, undefined]);
});

it("says why a rollout cannot start with a clip, and keeps the earlier start", async () => {
  starts.chooseClip("made-wave-1");
  await settled();
  whole.starts.at(-1)?.fail(new Error("expected 15 frames or more"));
  await settled();
  expect([starts.clip, model.clipStart]).toEqual([null, null]);
  expect(notices.all.map(({ title, text }) => `${title}: ${text}`)).toEqual([
    expect.stringContaining("expected 15 frames or more"),
  ]);
});
