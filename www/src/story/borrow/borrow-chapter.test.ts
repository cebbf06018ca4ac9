import { beforeEach, expect, it } from "vitest";
import { HeldWorkers } from "../../engine/held.fake";
import { libraryText } from "../../primitives/learned.fake";
import { LibraryStore } from "../../primitives/library-store";
import { SettingsStore } from "../../settings/settings-store";
import { NoticesStore } from "../../ui/notices-store";
import { words } from "../../words/en";
import type { WordsStore } from "../../words/words";
import { NO_ADDRESS } from "../../app/story-body";
import { BorrowChapter, outcomeOf, measureHandsAndFeet } from "./borrow-chapter";
import type { LibraryInfo } from "../../engine/library-protocol";

let workers: HeldWorkers;
let library: LibraryStore;
let settings: SettingsStore;
let chapter: BorrowChapter;
beforeEach(async () => {
  workers = new HeldWorkers();
  library = new LibraryStore(workers, new NoticesStore(), async () => libraryText(1));
  settings = new SettingsStore(NO_ADDRESS);
  settings.change({ chapter: 8 });
  chapter = new BorrowChapter({ now: words } as unknown as WordsStore, settings, library);
  await library.openFirst();
});

it("shows a recorded movement, and after the guess its legs with the arms of another", async () => {
  chapter.arrive();
  await workers.settled();
  expect([library.uses, library.recorded]).toEqual([[0, 2], "walk"]);
  expect([chapter.control(), chapter.reveal()]).toEqual([null, null]);
  chapter.guessed("yes");
  expect([library.uses, library.recorded, chapter.guess()]).toEqual([[0, 3], null, null]);
});

it("leaves the Lab's combination as it was, but for a visitor who opens this one in the Lab", async () => {
  library.take([1, 2]);
  chapter.arrive();
  await workers.settled();
  chapter.guessed("yes");
  chapter.leave();
  expect(library.uses).toEqual([1, 2]);
  chapter.arrive();
  await workers.settled();
  chapter.guessed("yes");
  settings.change({ chapter: 0, view: "primitives" });
  chapter.leave();
  expect(library.uses).toEqual([0, 3]);
});

it("compares borrowed arms with both recorded movements", () => {
  const [walk, wave] = [
    { height: -0.1, speed: 0.6, steps: 2 },
    { height: 0.5, speed: 0.8, steps: 2 },
  ];
  expect(outcomeOf({ height: 0.4, speed: 0.7, steps: 2 }, wave, walk)).toBe("own");
  expect(outcomeOf({ height: 0, speed: 0.5, steps: 2 }, wave, walk)).toBe("legs");
  expect(outcomeOf({ height: 0.4, speed: 0.1, steps: 2 }, wave, walk)).toBe("still");
});

const names = ["Hips", "LeftHand", "RightHand", "LeftFoot", "RightFoot"];
const info = {
  joints: names.map((name) => ({ name, parent: null, channels: [] })),
  figure: { nodes: names.map((_, joint) => ({ joint, parent: null, endSite: false })) },
} as unknown as Pick<LibraryInfo, "joints" | "figure">;

it("measures hands that rise and swing, and feet that step twice a second, while the body moves on", () => {
  const [frames, rate] = [301, 100];
  const positions = new Float32Array(frames * 15);
  for (let frame = 0; frame < frames; frame++) {
    const t = frame / rate;
    const x = 1.2 * t;
    const stride = 0.3 * Math.cos(2 * Math.PI * t);
    const places = [
      [x, 1, 0],
      [x, 1.5, 0.5 * t],
      [x, 1.3, 0.5 * t],
      [x + stride, 0, 0],
      [x - stride, 0, 0],
    ];
    positions.set(places.flat(), 15 * frame);
  }
  const measured = measureHandsAndFeet(info, { positions, frames, nodes: 5, frameTime: 1 / rate });
  expect(measured?.height).toBeCloseTo(0.4, 5);
  expect(measured?.speed).toBeCloseTo(0.5, 4);
  expect(measured?.steps).toBeCloseTo(2, 5);
});

it("counts no steps of feet that spread and close in one place", () => {
  const [frames, rate] = [201, 100];
  const positions = new Float32Array(frames * 15);
  for (let frame = 0; frame < frames; frame++) {
    const t = frame / rate;
    const sway = 0.01 * Math.cos(2 * Math.PI * t);
    const spread = 0.3 * Math.sin(2 * Math.PI * t);
    positions.set([sway, 1, 0, 0, 1.5, 0, 0, 1.5, 0, spread, 0, 0, -spread, 0, 0], 15 * frame);
  }
  expect(measureHandsAndFeet(info, { positions, frames, nodes: 5, frameTime: 1 / rate })?.steps).toBe(0);
});

it("measures nothing on a body without hands", () => {
  const motion = { positions: new Float32Array(30), frames: 2, nodes: 5, frameTime: 0.1 };
  expect(measureHandsAndFeet({ ...info, joints: info.joints.slice(0, 1) }, motion)).toBeNull();
});
