import { expect, it } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { HeldWorkers } from "../engine/held.fake";
import { libraryText } from "./learned.fake";
import { RecordedStore } from "./recorded-store";

class FakeClips {
  all: ClipEntry[] = [];
  readonly added: [string, string][] = [];
  async addModelled(title: string, bvh: string): Promise<string> {
    this.added.push([title, bvh]);
    return title;
  }
}

it("adds the clips of the models once, and keeps the models", async () => {
  const clips = new FakeClips();
  const workers = new HeldWorkers();
  const recorded = new RecordedStore(workers, clips, async () => libraryText(1));
  await Promise.all([recorded.load(), recorded.load()]);
  expect(clips.added.map(([title]) => title)).toEqual([
    "Walk 1, by a model of CMU 35",
    "Wave 1, by a model of CMU 141",
  ]);
  const { clips: read } = workers.started();
  for (const [, bvh] of clips.added) {
    const { info } = await read.readClip({ name: "clip.bvh", file: new Blob([bvh]) });
    expect(info.frames).toBe(5 * 30);
  }
  const made = await workers.desk.run((worker) => worker.recordedMovements(libraryText(1)));
  expect(recorded.movements).toEqual(made);
  expect(clips.added.map(([, bvh]) => bvh)).toEqual(made.flatMap(({ clips }) => clips));
});

it("adds no clips twice that an earlier visit brought back", async () => {
  const clips = new FakeClips();
  clips.all = [{ origin: "model" } as ClipEntry];
  const recorded = new RecordedStore(new HeldWorkers(), clips, async () => libraryText(1));
  await recorded.load();
  expect([clips.added, recorded.movements.length]).toEqual([[], 2]);
});

it("says why the library did not come, and tries again", async () => {
  let fails = true;
  const recorded = new RecordedStore(new HeldWorkers(), new FakeClips(), async () => {
    if (fails) throw new Error("the host did not answer");
    return libraryText(1);
  });
  await recorded.load();
  expect([recorded.problem, recorded.movements]).toEqual(["the host did not answer", []]);
  fails = false;
  await recorded.load();
  expect([recorded.problem, recorded.movements.length]).toEqual(["", 2]);
});
