import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "./lab.fake";
import { modelText } from "../engine/documents.fake";
import type { TrainingClip } from "../engine/protocol";
import { ClipStartStore } from "./clip-start-store";

let { workers, model, clips, notices, settings } = new HeldLab();
let starts: ClipStartStore;
beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, model, clips, notices, settings } = lab);
  starts = new ClipStartStore(lab.store, model, clips, notices, workers);
  await lab.start(modelText(1, 2, 30));
  await clips.loadSamples();
});

/** Chooses a clip, and lets the worker infer its start. */
async function choose(key: string): Promise<void> {
  starts.chooseClip(key);
  await workers.settled();
}

it("starts the rollouts, and the outline, with the first half second of a clip", async () => {
  expect(starts.clips.map(({ title }) => title)).toEqual(clips.all.map(({ title }) => title));
  model.setStart(1, 3);
  await choose("made-walk-wave-1");
  const [[text, clip, frames]] = workers.asked("inferStart") as [[string, TrainingClip, number]];
  expect(JSON.parse(text)).toEqual(JSON.parse(modelText(1, 2, 30)));
  const { end } = clips.all.find(({ key }) => key === "made-walk-wave-1")!;
  expect([clip, frames]).toMatchObject([{ source: { sample: "walk-wave-1" }, first: 0, end }, 15]);
  const { latents } = model.clipStart!;
  expect(latents.map((part) => part.length)).toEqual([15, 15]);
  expect([starts.clip, starts.observed, model.rollout?.request]).toEqual([
    "made-walk-wave-1",
    0.5,
    { frames: 300, sequence: 0, start: latents, alpha: null, reading: "as-learned" },
  ]);
  expect(model.rollout!.latents.map((path) => [...path.slice(0, 30)])).toEqual(
    latents.map((part) => part.flat()),
  );
  expect([settings.values.start, settings.values.startFrame]).toEqual([0, 0]);

  model.couplings.set(0, 1, 20);
  await workers.settled();
  expect(model.rollout?.request).toMatchObject({ start: latents, reading: "re-inferred" });
  expect(model.learned?.request).toMatchObject({ start: latents, alpha: null });

  starts.chooseSequence(1);
  await workers.settled();
  const found = [starts.clip, model.rollout?.request.sequence, model.rollout?.request.start];
  expect(found).toEqual([null, 1, undefined]);
});

it("leaves out clips that the model was trained on, and keeps a start whose clip was removed", async () => {
  const keys = () => starts.clips.map(({ key }) => key);
  const [first, ...others] = keys();
  await model.open(modelText(1, 2).replaceAll("walk 1", clips.all[0]!.loaded.info.sha256));
  expect([first, keys()]).toEqual(["made-walk-1", others]);
  await choose("made-walk-2");
  await clips.remove("made-walk-2");
  expect(keys()).toEqual([...others.slice(1), "made-walk-2"]);
});

it("drops a start that arrives after another choice or another model", async () => {
  workers.hold("inferStart");
  await choose("made-walk-wave-1");
  expect([starts.clip, starts.isBusy]).toEqual(["made-walk-wave-1", true]);
  starts.chooseSequence(1);
  workers.held("inferStart")[0]!.go();
  await workers.settled();
  expect([starts.clip, starts.isBusy, model.clipStart]).toEqual([null, false, null]);

  await choose("made-walk-wave-1");
  await model.open(modelText(2));
  workers.held("inferStart")[1]!.go();
  await workers.settled();
  expect([starts.clip, model.clipStart]).toEqual([null, null]);

  // Another model starts as its own first sequence again.
  workers.letGo("inferStart");
  await choose("made-walk-wave-1");
  expect(model.clipStart?.key).toBe("made-walk-wave-1");
  await model.open(modelText(3));
  expect([starts.clip, model.rollout?.request.start]).toEqual([null, undefined]);
});

it("says why a rollout cannot start with a clip, and keeps the earlier start", async () => {
  await choose("made-walk-2");
  const { clipStart } = model;
  clips.cut("made-walk-wave-1", 0, 20);
  await choose("made-walk-wave-1");
  expect([starts.clip, model.clipStart === clipStart]).toEqual(["made-walk-2", true]);
  expect(notices.all.map(({ title, text }) => `${title}: ${text}`)).toEqual([
    expect.stringContaining("15 frames"),
  ]);
});
