import { beforeEach, describe, expect, it } from "vitest";
import type { ClipEntry, ClipsStore } from "../clips/clips-store";
import { HeldWorkers } from "../engine/held.fake";
import { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { libraryText, madeInfo } from "./learned.fake";
import { LibraryStore } from "./library-store";
import { bandsOf, nameOf, RecognitionStore } from "./recognition-store";

/** Clips that tests put there. */
class FakeClips extends Store {
  all: ClipEntry[] = [];

  ofBody(joints: readonly { name: string }[]): ClipEntry[] {
    const names = (all: readonly { name: string }[]) => all.map(({ name }) => name).join();
    return this.all.filter(({ loaded }) => names(loaded.info.joints) === names(joints));
  }

  set(...clips: ClipEntry[]): void {
    this.all = clips;
    this.changed();
  }
}

let ids = 0;
function clip(key: string, origin: "made" | "own", joints: { name: string }[] = madeInfo.joints): ClipEntry {
  const source = origin === "made" ? { sample: key } : { name: key, file: new Blob() };
  const loaded = { id: ++ids, info: { joints } };
  return { key, title: key, origin, source, loaded, first: 0, end: 12 } as unknown as ClipEntry;
}

let workers: HeldWorkers;
let library: LibraryStore;
let clips: FakeClips;
let recognition: RecognitionStore;
const chosen = () => recognition.chosen.map((clip) => clip?.key ?? "");
beforeEach(async () => {
  workers = new HeldWorkers();
  library = new LibraryStore(workers, new NoticesStore(), async () => libraryText(1));
  clips = new FakeClips();
  recognition = new RecognitionStore(workers, clips as unknown as ClipsStore, library);
  await library.openFirst();
  clips.set(...["walk-1", "walk-2", "walk-wave-1", "walk-wave-2"].map((key) => clip(key, "made")));
});

describe("the clips that are recognised", () => {
  it("are at first a made walk, a wave and another walk", () => {
    expect(chosen()).toEqual(["walk-1", "walk-wave-1", "walk-2"]);
  });

  it("are those of the visitor as soon as there are any of the same body", () => {
    clips.set(...clips.all, clip("mine", "own"), clip("dog", "own", [{ name: "spine" }, { name: "tail" }]));
    expect(chosen()).toEqual(["mine", "", ""]);
    expect(recognition.clips.map(({ key }) => key)).not.toContain("dog");
  });

  it("can be chosen, and none at a place", async () => {
    recognition.choose(0, "walk-2");
    recognition.choose(2, "");
    expect(chosen()).toEqual(["walk-2", "walk-wave-1", ""]);
    await recognition.recognise();
    expect(workers.asked("recognise")[0]?.[0].clips.map(({ source }) => source)).toEqual([
      { sample: "walk-2" },
      { sample: "walk-wave-1" },
    ]);
  });
});

describe("a recognised recording", () => {
  it("plays, and belongs to the library and the clips of its question", async () => {
    await recognition.recognise();
    const { segments, motion } = recognition.found!;
    // Every frame of the three clips, in order, at half their rate.
    const starts = [0, ...segments.map(({ end }) => end)];
    expect([...segments.map(({ first }) => first), motion.frames]).toEqual(starts);
    expect([motion.frames, recognition.player.last]).toEqual([18, 17]);
    recognition.goTo(3);
    expect([recognition.player.frame, recognition.player.playing]).toEqual([3, false]);
    recognition.choose(0, "walk-2");
    expect(recognition.found).toBeNull();
    await recognition.recognise();
    await library.open(libraryText(2), "another", false);
    expect(recognition.found).toBeNull();
  });

  it("tells how much is done, and can be cancelled", async () => {
    const first = recognition.recognise();
    expect(recognition.fraction).toBe(0);
    recognition.cancel();
    await first;
    expect([recognition.found, recognition.fraction]).toEqual([null, null]);
  });

  it("is dropped when another question came meanwhile", async () => {
    // The worker reads the signal too late.
    workers.answer("recognise", (real, job, report) => real(job, report, new AbortController().signal));
    const first = recognition.recognise();
    recognition.choose(0, "walk-2");
    await first;
    await workers.settled();
    expect([recognition.found, recognition.fraction]).toEqual([null, null]);
  });

  it("says why there is none", async () => {
    clips.set(...clips.all, clip("mine", "own"));
    await recognition.recognise();
    const shown = [recognition.problem, recognition.found, recognition.fraction];
    expect(shown).toEqual([expect.stringMatching(/^mine, line 1/), null, null]);
    recognition.choose(1, "");
    expect(recognition.problem).toBe("");
  });
});

it("a part that keeps its primitive while another part changes has one band", () => {
  const segments = [
    { movement: 0, uses: [4, 6] },
    { movement: null, uses: [4, 7] },
    { movement: 1, uses: [5, 7] },
  ].map((segment, k) => ({ ...segment, first: k, end: k + 1, probability: 1 }));
  expect(bandsOf(segments, 0)).toEqual([
    { primitive: 4, first: 0, end: 2 },
    { primitive: 5, first: 2, end: 3 },
  ]);
  expect(bandsOf(segments, 1)).toEqual([
    { primitive: 6, first: 0, end: 1 },
    { primitive: 7, first: 1, end: 3 },
  ]);
});

it("parts that use primitives of several movements are named one by one", () => {
  const info = library.current?.info;
  if (!info) throw new Error("the library is open");
  const [walk, wave] = info.movements.map(({ uses }) => uses);
  const mixed = [walk?.[0] ?? -1, wave?.[1] ?? -1];
  const segment = { first: 0, end: 1, probability: 1 };
  expect(nameOf({ ...segment, movement: 1, uses: wave ?? [] }, info)).toBe("wave");
  expect(nameOf({ ...segment, movement: null, uses: mixed }, info)).toBe("legs: walk; arms: wave");
});
