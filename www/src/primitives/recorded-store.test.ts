import { expect, it } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { libraryText } from "../engine/library.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
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
  const recorded = new RecordedStore(new FakeProgram(), clips, async () => libraryText("first"));
  await Promise.all([recorded.load(), recorded.load()]);
  expect(clips.added).toEqual([
    ["Walk 1, by a model of CMU 35", "bvh of walk"],
    ["Wave 1, by a model of CMU 141", "bvh of wave"],
  ]);
  expect(recorded.movements.map(({ name, model }) => [name, model])).toEqual([
    ["walk", "model of walk"],
    ["wave", "model of wave"],
  ]);
});

it("adds no clips twice that an earlier visit brought back", async () => {
  const clips = new FakeClips();
  clips.all = [{ origin: "model" } as ClipEntry];
  const recorded = new RecordedStore(new FakeProgram(), clips, async () => libraryText("first"));
  await recorded.load();
  expect([clips.added, recorded.movements.length]).toEqual([[], 2]);
});

it("says why the library did not come, and tries again", async () => {
  let fails = true;
  const recorded = new RecordedStore(new FakeProgram(), new FakeClips(), async () => {
    if (fails) throw new Error("the host did not answer");
    return libraryText("first");
  });
  await recorded.load();
  expect([recorded.problem, recorded.movements]).toEqual(["the host did not answer", []]);
  fails = false;
  await recorded.load();
  expect([recorded.problem, recorded.movements.length]).toEqual(["", 2]);
});
