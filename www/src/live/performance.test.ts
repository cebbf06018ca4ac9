import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { noteOf } from "../clips/clips-store";
import { startModel } from "../engine/start-model.fake";
import { loadPerforming } from "../words/sections";
import { WordsStore } from "../words/words";
import type { LiveStore } from "./live-store";
import { modelLive } from "./model-live";
import { Performance } from "./performance";
import type { RecordedParts } from "./recorded-parts";

let { workers, clips, playback, notices } = new HeldLab();
let live: LiveStore;
let performed: Performance;

beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, clips, playback, notices } = lab);
  await lab.start((await startModel()).text, { couplings: "link", clip: false });
  await loadPerforming(new WordsStore());
  live = modelLive({ ...lab, engine: lab.store });
  const others = { engine: lab.store, workers, training: { start: async () => {} } };
  performed = new Performance(live, {} as RecordedParts, { ...lab, ...others });
});

/** Lets seconds of the visitor's time pass, with this many pictures a second. */
async function pass(seconds: number, pictures = 15): Promise<void> {
  for (let k = 0; k < seconds * pictures; k++) {
    playback.advance(1 / pictures);
    await workers.settled();
  }
}

it("records ten seconds that the stage shows as a clip which says how it was made", async () => {
  await performed.start();
  expect([live.running, performed.isRecording, performed.left]).toEqual([true, true, 10]);
  await pass(7);
  // A second press does not begin again.
  await performed.start();
  live.drive(0, 0.1, true);
  await live.hold(0, 1, true);
  await pass(1.1, 60);
  expect(performed.left).toBe(2);
  await pass(2, 60);
  await workers.settled();
  expect([performed.isRecording, performed.busy]).toEqual([false, false]);
  const [clip] = clips.all;
  expect(clip).toMatchObject({
    key: performed.clip?.key,
    title: "performed 1",
    origin: "own",
    ticked: false,
  });
  expect(noteOf(clip!)).toMatch(
    /^Made by you, live from the model .+, with two fingers as the feet; .+ cut\.$/,
  );
  const { file } = clip!.source as { file: Blob };
  expect([clip!.loaded.info.frames, await file.text()]).toEqual([301, expect.stringMatching(/^HIERARCHY/)]);
  // Training on it leaves the other clips out.
  await performed.train();
  expect(clips.ticked).toEqual([{ ...clip, ticked: true }]);
});

it("ends with the live motion, and keeps nothing that is too short for a clip", async () => {
  await performed.start();
  await pass(0.5);
  live.stop();
  await workers.settled();
  expect([performed.isRecording, clips.all.length]).toEqual([false, 0]);
  expect(notices.all.map(({ title }) => title)).toEqual(["Nothing was recorded"]);
  await performed.start();
  await pass(2);
  live.stop();
  await workers.settled();
  expect(performed.clip?.title).toBe("performed 1");
});
