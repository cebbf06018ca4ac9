import { beforeEach, expect, it } from "vitest";
import { libraryText } from "../../engine/library.fake";
import { FakeProgram, settled } from "../../engine/whole-workers.fake";
import { LibraryStore } from "../../primitives/library-store";
import { SettingsStore } from "../../settings/settings-store";
import { NoticesStore } from "../../ui/notices-store";
import { words } from "../../words/en";
import type { WordsStore } from "../../words/words";
import { NO_ADDRESS } from "../../app/story-body";
import { BorrowChapter, outcomeOf } from "./borrow-chapter";

let library: LibraryStore;
let settings: SettingsStore;
let chapter: BorrowChapter;
beforeEach(async () => {
  library = new LibraryStore(new FakeProgram(), new NoticesStore(), async () => libraryText("first"));
  settings = new SettingsStore(NO_ADDRESS);
  settings.change({ chapter: 8 });
  chapter = new BorrowChapter({ now: words } as unknown as WordsStore, settings, library);
  await library.openFirst();
});

it("shows a recorded movement, and after the guess its legs with the arms of another", async () => {
  chapter.arrive();
  await settled();
  expect([library.uses, library.recorded]).toEqual([[0, 2], "walk"]);
  expect([chapter.control(), chapter.reveal()]).toEqual([null, null]);
  chapter.guessed();
  expect([library.uses, library.recorded, chapter.guess()]).toEqual([[0, 3], null, null]);
});

it("leaves the Lab's combination as it was, but for a visitor who opens this one in the Lab", async () => {
  library.take([1, 2]);
  chapter.arrive();
  await settled();
  chapter.guessed();
  chapter.leave();
  expect(library.uses).toEqual([1, 2]);
  chapter.arrive();
  await settled();
  chapter.guessed();
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
