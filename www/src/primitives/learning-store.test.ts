import { beforeEach, expect, it } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { HeldWorkers } from "../engine/held.fake";
import type { SampleInfo } from "../engine/protocol";
import { initialSettings, type Settings } from "../settings/settings";
import { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { libraryText, madeInfo } from "./learned.fake";
import { LearningStore } from "./learning-store";
import { LibraryStore } from "./library-store";

class FakeSettings extends Store {
  values: Settings = { ...initialSettings(), latent: 1, dynamicsIps: 2, poseIps: 2, maxIterations: 2 };
}
class FakeClips extends Store {
  all: ClipEntry[] = [];
  samplesLoaded = true;
  add(key: string, origin: ClipEntry["origin"]): void {
    const loaded = { id: this.all.length + 1, info: madeInfo, motion: {} };
    const source = origin === "made" ? { sample: key } : { name: key, file: new Blob() };
    const clip = { key, title: `title of ${key}`, origin, source, loaded, ticked: true, first: 0, end: 60 };
    this.all = [...this.all, clip as unknown as ClipEntry];
    this.changed();
  }
}
const sample = (id: string, movement: string): SampleInfo => ({ id, title: id, movement });

let workers: HeldWorkers;
let clips: FakeClips;
let library: LibraryStore;
let learning: LearningStore;
beforeEach(() => {
  [workers, clips] = [new HeldWorkers(), new FakeClips()];
  library = new LibraryStore(workers, new NoticesStore(), async () => libraryText(1));
  const samples = [
    ...["walk-1", "walk-2", "walk-3"].map((id) => sample(id, "walk")),
    sample("walk-wave-1", "wave"),
  ];
  learning = new LearningStore(workers, { samples }, new FakeSettings(), clips, library);
  for (const { id } of samples) clips.add(id, "made");
});
const chosen = () =>
  learning.clips.filter(({ chosen }) => chosen).map(({ key, movement }) => `${key} ${movement}`);

it("leaves clips that a model made out, until they are chosen", () => {
  clips.add("Run 1, by a model", "model");
  expect(chosen()).toEqual(["walk-1 walk", "walk-2 walk", "walk-wave-1 wave"]);
  learning.choose("Run 1, by a model", true);
  expect(chosen().at(-1)).toBe("Run 1, by a model title of Run");
});

it("groups sample clips by their movements, and own clips by their names", () => {
  expect(chosen()).toEqual(["walk-1 walk", "walk-2 walk", "walk-wave-1 wave"]);
  clips.add("mine", "own");
  expect(chosen()).toEqual(["mine title of mine"]);
  expect(learning.whyNot).toBe("Choose clips of another movement too.");
  learning.choose("walk-3", true);
  learning.rename("walk-3", " run ");
  expect(chosen()).toEqual(["walk-3 run", "mine title of mine"]);
  learning.rename("walk-3", " ");
  expect(chosen()[0]).toBe("walk-3 walk");
});

it("learns the groups, and opens the library", async () => {
  await library.openFirst();
  learning.rename("walk-wave-1", "walk");
  learning.rename("walk-2", "other");
  learning.setShared("lower", true);
  await learning.learn();
  expect(workers.asked("learnLibrary")[0]?.[0].clips.map(({ id }) => id)).toEqual([1, 4, 2]);
  expect([learning.iteration, learning.fraction]).toEqual([2, 1]);
  const { info, unsaved } = library.current!;
  expect([unsaved, learning.ending]).toEqual([true, { words: "all iterations used", failed: false }]);
  const [walk, other] = info.movements;
  expect(info.movements.map(({ name, sequences }) => [name, sequences.length])).toEqual([
    ["walk", 2],
    ["other", 1],
  ]);
  expect([walk?.uses, other?.uses]).toEqual([
    [0, 1],
    [0, 2],
  ]);
  await library.undo();
  expect(library.current?.text).toBe(libraryText(1));
});

it("keeps the best library when it is cancelled", async () => {
  await library.openFirst();
  workers.hold("learnLibrary");
  const learned = learning.learn();
  await workers.settled();
  learning.cancel();
  await learned;
  expect(learning.iteration).toBe(1);
  expect([library.current?.unsaved, library.current?.text === libraryText(1)]).toEqual([true, false]);
  expect(learning.ending.words).toMatch(/cancelled/);
});
