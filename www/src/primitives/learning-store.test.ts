import { beforeEach, expect, it } from "vitest";
import { progress } from "../engine/engine.fake";
import type { ClipEntry } from "../clips/clips-store";
import { libraryText } from "../engine/library.fake";
import type { TrainingReport } from "../engine/protocol";
import type { ClipInfo, SampleInfo } from "../engine/protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { initialSettings, type Settings } from "../settings/settings";
import { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { LearningStore } from "./learning-store";
import { LibraryStore } from "./library-store";

class FakeSettings extends Store {
  values: Settings = initialSettings();
}
class FakeClips extends Store {
  all: ClipEntry[] = [];
  samplesLoaded = true;
  add(key: string, origin: ClipEntry["origin"]): void {
    const parts = [
      { name: "legs", joints: [0] },
      { name: "arms", joints: [1] },
    ];
    const info = { joints: [{ parent: null }, { parent: 0 }], presets: [{ id: "two", title: "", parts }] };
    const loaded = { id: this.all.length + 1, info: info as unknown as ClipInfo, motion: {} };
    const source = origin === "made" ? { sample: key } : { name: key, file: new Blob() };
    const clip = { key, title: `title of ${key}`, origin, source, loaded, ticked: true, first: 0, end: 90 };
    this.all = [...this.all, clip as unknown as ClipEntry];
    this.changed();
  }
}
const sample = (id: string, movement: string): SampleInfo => ({ id, title: id, movement });

let program: FakeProgram;
let clips: FakeClips;
let library: LibraryStore;
let learning: LearningStore;
beforeEach(() => {
  [program, clips] = [new FakeProgram(), new FakeClips()];
  library = new LibraryStore(program, new NoticesStore(), async () => libraryText("first"));
  const samples = [sample("w1", "walk"), sample("w2", "walk"), sample("w3", "walk"), sample("v1", "wave")];
  learning = new LearningStore(program, { samples }, new FakeSettings(), clips, library);
  for (const { id } of samples) clips.add(id, "made");
});
const chosen = () =>
  learning.clips.filter(({ chosen }) => chosen).map(({ key, movement }) => `${key} ${movement}`);
const report = (found: string | null) =>
  ({ progress: { ...progress(3), fraction: 0.5 }, elapsed: 2, found }) as TrainingReport<string>;

it("leaves clips that a model made out, until they are chosen", () => {
  clips.add("Run 1, by a model", "model");
  expect(chosen()).toEqual(["w1 walk", "w2 walk", "v1 wave"]);
  learning.choose("Run 1, by a model", true);
  expect(chosen().at(-1)).toBe("Run 1, by a model title of Run");
});

it("groups sample clips by their movements, and own clips by their names", () => {
  expect(chosen()).toEqual(["w1 walk", "w2 walk", "v1 wave"]);
  clips.add("mine", "own");
  expect(chosen()).toEqual(["mine title of mine"]);
  expect(learning.whyNot).toBe("Choose clips of another movement too.");
  learning.choose("w3", true);
  learning.rename("w3", " run ");
  expect(chosen()).toEqual(["w3 run", "mine title of mine"]);
  learning.rename("w3", " ");
  expect(chosen()[0]).toBe("w3 walk");
});

it("learns the groups, and opens the library", async () => {
  await library.openFirst();
  learning.rename("v1", "walk");
  learning.rename("w2", "other");
  learning.setShared("legs", true);
  const learned = learning.learn();
  await settled();
  const [training] = program.libraries.learnings;
  expect(training?.job).toMatchObject({
    clips: [{ id: 1 }, { id: 4 }, { id: 2 }],
    movements: [
      { name: "walk", sequences: 2 },
      { name: "other", sequences: 1 },
    ],
    shared: [true, false],
  });
  training?.report(report(null));
  expect([learning.iteration, learning.fraction]).toEqual([3, 0.5]);
  training?.report(report(libraryText("learned")));
  training?.end({ cancelled: false, reason: "settled" });
  await learned;
  expect(library.current).toMatchObject({ text: libraryText("learned"), unsaved: true });
  expect(learning.ending).toEqual({ words: "the objective no longer rises", failed: false });
  await library.undo();
  expect(library.current?.text).toBe(libraryText("first"));
});

it("keeps the best library when it is cancelled", async () => {
  await library.openFirst();
  const learned = learning.learn();
  await settled();
  program.libraries.learnings[0]?.report(report(libraryText("early")));
  learning.cancel();
  await learned;
  expect(library.current?.text).toBe(libraryText("early"));
  expect(learning.ending.words).toMatch(/cancelled/);
});
