import { beforeEach, describe, expect, it } from "vitest";
import { armsText, libraryText } from "../engine/library.fake";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { NoticesStore } from "../ui/notices-store";
import { LibraryStore } from "./library-store";
import { TRANSITION_FRAMES } from "../live/transition";

let program: FakeProgram;
let notices: NoticesStore;
let library: LibraryStore;
let first: () => Promise<string>;
beforeEach(() => {
  [program, notices] = [new FakeProgram(), new NoticesStore()];
  first = async () => libraryText("first");
  library = new LibraryStore(program, notices, () => first());
});

/** Lets seconds of the visitor's time pass. */
async function pass(seconds: number): Promise<void> {
  for (let k = 0; k < seconds * 60; k++) {
    library.playback.advance(1 / 60);
    await settled();
  }
}

/** The first library is open, and its figure walks. */
async function opened(): Promise<void> {
  await library.openFirst();
  await settled();
  library.playback.play();
}

describe("a library", () => {
  it("opens with a combination that was never recorded, and with all small figures", async () => {
    await opened();
    expect(library.uses).toEqual([0, 3]);
    expect(library.recorded).toBeNull();
    expect(library.title).toBe("legs: walk, arms: wave");
    expect(program.libraries.walks).toEqual([[0, 3]]);
    await settled();
    expect(library.combinations.map((uses) => library.motionOf(uses)?.frames)).toEqual([120, 120, 120, 120]);
    await library.openFirst();
    expect(program.libraries.opened).toHaveLength(1);
  });

  it("reports why it cannot be opened, and can be opened again", async () => {
    first = () => Promise.reject(new Error("no such file"));
    await library.openFirst();
    expect(library.problem).toBe("no such file");
    first = async () => libraryText("first");
    await opened();
    expect(library.problem).toBe("");
    expect(library.current?.title).toBe("");
  });

  it("is replaced by another, which can be undone; a refused file changes nothing", async () => {
    await opened();
    await library.open(libraryText("second"), "second.json");
    expect(library.current?.title).toBe("second.json");
    program.libraries.refused = "expected a library";
    await expect(library.open("{}", "bad.json")).rejects.toThrow("expected a library");
    program.libraries.refused = "";
    expect(library.current?.title).toBe("second.json");
    // The worker that refused the file was replaced, and the next worker has the open library.
    expect(JSON.parse(await library.combinationText())).toMatchObject({ library: libraryText("second") });
    await library.undo();
    expect(library.current?.text).toBe(libraryText("first"));
    expect(library.before).toBeNull();
  });

  it("that is not saved can be brought back after any number of others", async () => {
    await opened();
    await library.open(libraryText("learned"), "learned", true);
    await library.open(libraryText("second"), "second.json");
    await library.open(libraryText("third"), "third.json");
    expect(library.unsaved.map(({ title }) => title)).toEqual(["learned"]);
    const titles: (string | undefined)[] = [];
    for (let k = 0; k < 3; k++) {
      await library.undo();
      titles.push(library.current?.title);
    }
    expect(titles).toEqual(["second.json", "learned", "learned"]);
    expect(library.before).toBeNull();
  });

  it("adds a combination while the figure walks on", async () => {
    await opened();
    await library.keep("mine");
    expect(library.current?.info.movements.map(({ name }) => name)).toEqual(["walk", "wave", "mine"]);
    expect(library.current?.unsaved).toBe(true);
    expect(program.libraries.walks).toHaveLength(1);
    expect(library.save()).toBe(libraryText("first", ["mine"]));
    expect(library.current?.unsaved).toBe(false);
  });
});

describe("the combination that walks", () => {
  it("continues with another primitive, under the couplings of the nearest movement", async () => {
    await opened();
    library.couplings.set(0, 1, 9);
    expect(library.couplings.altered).toBe(true);
    library.choose(1, 2);
    await pass(0.5);
    expect(library.uses).toEqual([0, 2]);
    expect(library.recorded).toBe("walk");
    expect(library.couplings.altered).toBe(false);
    expect(program.libraries.live.changes.slice(-2)).toMatchObject([
      { kind: "use", part: 1, primitive: 2 },
      { kind: "nearest", uses: [0, 2] },
    ]);
    expect(library.couplings.alpha).toEqual(library.couplings.learned);
    expect(program.libraries.walks).toHaveLength(1);
    library.choose(1, 0);
    expect(library.uses).toEqual([0, 2]);
  });

  it("has no jump", async () => {
    await opened();
    await pass(0.5);
    library.take([1, 2]);
    library.take([1, 3]);
    await pass(2);
    const { positions, frames, nodes } = library.walk.track?.motion ?? { positions: [], frames: 0, nodes: 1 };
    let largest = 0;
    for (let i = 3 * nodes; i < frames * nodes * 3; i++)
      largest = Math.max(largest, Math.abs((positions[i] ?? 0) - (positions[i - 3 * nodes] ?? 0)));
    // The jump from 3 to 4 takes fifteen frames.
    expect(positions[3 * nodes * frames - 1]).toBeCloseTo(4);
    expect(largest).toBeLessThan(0.11);
    expect(largest).toBeGreaterThan(0.05);
  });

  it("uses another primitive from the visible frame on, and computes later frames again", async () => {
    await opened();
    await pass(0.5);
    const { walk } = library;
    const seen = Math.floor(library.playback.frame);
    const before = [...(walk.track?.frame(seen) ?? [])];
    const ahead = [...(walk.track?.frame(seen + 1) ?? [])];
    expect(walk.track?.last).toBeGreaterThanOrEqual(seen + 3);
    library.choose(1, 2);
    await settled();
    expect([...(walk.track?.frame(seen) ?? [])]).toEqual(before);
    expect([...(walk.track?.frame(seen + 1) ?? [])]).not.toEqual(ahead);
    const { back, frames } = program.libraries.live.steps.at(-1) ?? { back: 0, frames: 0 };
    expect(back).toBeGreaterThanOrEqual(2);
    expect(frames).toBeGreaterThanOrEqual(back);
    // A second change computes the frames of the first change again.
    library.setTempo(0, 1.5);
    await settled();
    expect(program.libraries.live.changes.slice(-3)).toMatchObject([
      { kind: "use", part: 1, primitive: 2 },
      { kind: "nearest" },
      { kind: "tempo", part: 0 },
    ]);
    library.choose(1, 3);
    await settled();
    expect(program.libraries.live.changes.slice(-3)).toMatchObject([
      { kind: "tempo", part: 0 },
      { kind: "use", part: 1, primitive: 3 },
      { kind: "nearest" },
    ]);
    await pass(1);
    expect(walk.track?.frame(walk.track.last)?.[0]).toBe(3);
  });

  it("moves a paused figure to the end of the transition", async () => {
    await opened();
    await pass(0.52);
    const { walk } = library;
    library.playback.togglePlay();
    const { frame } = library.playback;
    const now = () => walk.track?.frame(library.playback.frame)?.[0];
    const before = now();
    library.choose(1, 2);
    await settled();
    expect(library.playback.frame).toBe(Math.ceil(frame) + TRANSITION_FRAMES);
    expect(walk.track?.last).toBeGreaterThanOrEqual(library.playback.frame + 1);
    expect([before, now()]).toEqual([3, 2]);
    // A coupling does not move a paused figure.
    library.couplings.set(0, 1, 5);
    await settled();
    expect(library.playback.frame).toBe(Math.ceil(frame) + TRANSITION_FRAMES);
    library.playback.play();
    await pass(1);
    expect(now()).toBe(2);
  });

  it("applies the newest couplings and tempos", async () => {
    await opened();
    for (const alpha of [5, 6, 7]) library.couplings.set(0, 1, alpha);
    expect(library.couplings.weight(0, 1)).toBeCloseTo(4 / 11, 12);
    library.setTempo(1, 1.2);
    library.setTempo(1, 1.3);
    library.setTempo(0, 0.9);
    await pass(1);
    const couplings = [
      [1, 7],
      [3, 4],
    ];
    expect(program.libraries.live.changes).toEqual([
      { kind: "couplings", alpha: couplings, reading: "as-learned" },
      { kind: "tempo", part: 1, tempo: 1.3 },
      { kind: "tempo", part: 0, tempo: 0.9 },
    ]);
    expect(JSON.parse(await library.combinationText())).toMatchObject({ uses: [0, 3], alpha: couplings });
    library.couplings.resetAll();
    expect(library.couplings.altered).toBe(false);
  });

  it("gets the primitives of a file that fit, and opens a whole library", async () => {
    await opened();
    await library.openFile(armsText("swing"), "swing.json");
    expect(library.addedText).toBe("Added arms: swing.");
    expect([library.current?.info.primitives.length, library.current?.unsaved]).toEqual([5, true]);
    await library.openFile(armsText("swing"), "swing.json");
    expect(library.addedText).toBe("These primitives are in the library already.");
    program.libraries.misfit = "the pose maps of upper differ";
    await expect(library.add(armsText("clap"))).rejects.toThrow("the pose maps of upper differ");
    expect(library.current?.info.primitives).toHaveLength(5);
    await library.openFile(libraryText("mine"), "mine.json");
    expect([library.current?.title, library.addedText]).toEqual(["mine.json", ""]);
  });

  it("is saved with its library, unless its couplings were changed", async () => {
    await opened();
    expect(library.isCombinationSaved, "the library of the page").toBe(true);
    library.choose(1, 2);
    expect(library.isCombinationSaved).toBe(true);
    library.couplings.set(0, 1, 5);
    expect(library.isCombinationSaved).toBe(false);
    library.couplings.resetAll();
    await library.open(libraryText("learned"), "The library learned here", true);
    expect(library.isCombinationSaved).toBe(false);
    library.save();
    expect(library.isCombinationSaved).toBe(true);
  });

  it("reports when it stops", async () => {
    await opened();
    program.libraries.broken = "no longer finite";
    await pass(0.3);
    expect(library.walk.track).toBeNull();
    expect(notices.all.at(-1)?.title).toBe("The live motion has ended");
  });
});
