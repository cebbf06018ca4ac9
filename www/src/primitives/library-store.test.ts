import { beforeEach, describe, expect, it } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import type { LiveStep } from "../engine/protocol";
import { NoticesStore } from "../ui/notices-store";
import { armsText, libraryText } from "./learned.fake";
import { LibraryStore } from "./library-store";
import { TRANSITION_FRAMES } from "../live/transition";

let workers: HeldWorkers;
let notices: NoticesStore;
let library: LibraryStore;
let first: () => Promise<string>;
/** The frames of the walk as the worker computed them last. */
let computed: Float32Array[];
const steps = (): LiveStep[] => workers.asked("advanceWalk").map(([step]) => step);
/** The changes that the worker was told last. */
const changes = () => steps().findLast(({ changes }) => changes.length > 0)?.changes;
/** The largest difference of a coordinate between two frames. */
const apart = (a?: Float32Array | null, b?: Float32Array | null) =>
  Math.max(...(a ?? []).map((value, i) => Math.abs(value - (b?.[i] ?? 0))));

beforeEach(() => {
  [workers, notices] = [new HeldWorkers(), new NoticesStore()];
  first = async () => libraryText(1);
  library = new LibraryStore(workers, notices, () => first());
  computed = [];
  workers.answer("advanceWalk", async (real, step) => {
    const next = await real(step);
    const { positions, frames, nodes } = next.motion;
    computed.length -= step.back;
    for (let k = 0; k < frames; k++) computed.push(positions.slice(3 * nodes * k, 3 * nodes * (k + 1)));
    return next;
  });
});

/** Lets seconds of the visitor's time pass. */
async function pass(seconds: number): Promise<void> {
  for (let k = 0; k < seconds * 60; k++) {
    library.playback.advance(1 / 60);
    await workers.settled();
  }
}

/** The first library is open, and its figure walks. */
async function opened(): Promise<void> {
  await library.openFirst();
  await workers.settled();
  library.playback.play();
}

describe("a library", () => {
  it("opens with a combination that was never recorded, and with all small figures", async () => {
    await opened();
    expect(library.uses).toEqual([0, 3]);
    expect(library.recorded).toBeNull();
    expect(library.title).toBe("legs: walk, arms: wave");
    expect(workers.asked("startWalk")).toEqual([[[0, 3]]]);
    await workers.settled();
    expect(library.combinations.map((uses) => library.motionOf(uses)?.frames)).toEqual([120, 120, 120, 120]);
    await library.openFirst();
    expect(workers.asked("openLibrary")).toHaveLength(1);
  });

  it("reports why it cannot be opened, and can be opened again", async () => {
    first = () => Promise.reject(new Error("no such file"));
    await library.openFirst();
    expect(library.problem).toBe("no such file");
    first = async () => libraryText(1);
    await opened();
    expect(library.problem).toBe("");
    expect(library.current?.title).toBe("");
  });

  it("is replaced by another, which can be undone; a refused file changes nothing", async () => {
    await opened();
    await library.open(libraryText(2), "second.json");
    expect(library.current?.title).toBe("second.json");
    await expect(library.open("{}", "bad.json")).rejects.toThrow("expected a model");
    expect(library.current?.title).toBe("second.json");
    // The worker that refused the file was replaced, and the next worker has the open library.
    expect(JSON.parse(await library.combinationText()).provenance.settings.seed).toBe(2);
    expect(workers.asked("openLibrary").slice(-2)).toEqual([["{}"], [libraryText(2)]]);
    await library.undo();
    expect(library.current?.text).toBe(libraryText(1));
    expect(library.before).toBeNull();
  });

  it("that is not saved can be brought back after any number of others", async () => {
    await opened();
    await library.open(libraryText(4), "learned", true);
    await library.open(libraryText(2), "second.json");
    await library.open(libraryText(3), "third.json");
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
    expect(workers.asked("startWalk")).toHaveLength(1);
    const { movements } = JSON.parse(library.save()) as { movements: { name: string }[] };
    expect(movements.map(({ name }) => name)).toEqual(["walk", "wave", "mine"]);
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
    expect(changes()).toEqual([
      { kind: "use", part: 1, primitive: 2 },
      { kind: "nearest", uses: [0, 2] },
    ]);
    expect(library.couplings.alpha).toEqual(library.current?.info.movements[0]?.alpha);
    expect(workers.asked("startWalk")).toHaveLength(1);
    library.choose(1, 0);
    expect(library.uses).toEqual([0, 2]);
  });

  it("has no jump", async () => {
    await opened();
    await pass(0.5);
    const { track } = library.walk;
    const seen = Math.floor(library.playback.frame);
    const expected = track?.frame(seen + 1)?.slice();
    library.take([1, 2]);
    library.take([1, 3]);
    await pass(1);
    // The jump fades over fifteen frames.
    const jump = apart(computed[seen + 1], expected);
    expect(jump).toBeGreaterThan(0.001);
    expect(apart(track?.frame(seen + 1), expected)).toBeLessThan(0.02 * jump);
    const shares = computed
      .slice(seen + 1, seen + 1 + TRANSITION_FRAMES)
      .map((frame, k) => apart(track?.frame(seen + 1 + k), frame) / jump);
    expect(shares.at(-1)).toBe(0);
    const falls = shares.slice(1).map((share, k) => shares[k]! - share);
    expect(Math.min(...falls)).toBeGreaterThan(0);
    expect(Math.max(...falls)).toBeGreaterThan(0.05);
    expect(Math.max(...falls)).toBeLessThan(0.11);
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
    await workers.settled();
    expect([...(walk.track?.frame(seen) ?? [])]).toEqual(before);
    expect([...(walk.track?.frame(seen + 1) ?? [])]).not.toEqual(ahead);
    const { back, frames } = steps().at(-1) ?? { back: 0, frames: 0 };
    expect(back).toBeGreaterThanOrEqual(2);
    expect(frames).toBeGreaterThanOrEqual(back);
    // A second change computes the frames of the first change again.
    library.setTempo(0, 1.5);
    await workers.settled();
    expect(changes()).toMatchObject([
      { kind: "use", part: 1, primitive: 2 },
      { kind: "nearest" },
      { kind: "tempo", part: 0 },
    ]);
    library.choose(1, 3);
    await workers.settled();
    expect(changes()).toMatchObject([
      { kind: "tempo", part: 0 },
      { kind: "use", part: 1, primitive: 3 },
      { kind: "nearest" },
    ]);
    await pass(1);
    expect(walk.track?.frame(walk.track.last)).toEqual(computed.at(-1));
  });

  it("moves a paused figure to the end of the transition", async () => {
    await opened();
    await pass(0.52);
    const { walk } = library;
    library.playback.togglePlay();
    const { frame } = library.playback;
    /** How far a frame is from the one that the worker computed. */
    const left = (at = Math.floor(library.playback.frame)) => apart(walk.track?.frame(at), computed[at]);
    library.choose(1, 2);
    await workers.settled();
    expect(library.playback.frame).toBe(Math.ceil(frame) + TRANSITION_FRAMES);
    expect(walk.track?.last).toBeGreaterThanOrEqual(library.playback.frame + 1);
    expect([left(Math.ceil(frame) + 1) > 0, left()]).toEqual([true, 0]);
    // A coupling does not move a paused figure.
    library.couplings.set(0, 1, 5);
    await workers.settled();
    expect(library.playback.frame).toBe(Math.ceil(frame) + TRANSITION_FRAMES);
    library.playback.play();
    await pass(1);
    expect(left()).toBe(0);
  });

  it("moves a paused figure on when the couplings of its movement replace one that was set meanwhile", async () => {
    await opened();
    await pass(0.5);
    library.playback.togglePlay();
    workers.hold("nearestCouplings");
    library.choose(1, 2);
    await workers.settled();
    library.couplings.set(0, 1, 9);
    const { frame } = library.playback;
    workers.held("nearestCouplings")[0]?.go();
    await workers.settled();
    expect(library.couplings.alpha).toEqual(library.current?.info.movements[0]?.alpha);
    expect(changes()?.at(-1)).toMatchObject({ kind: "couplings", alpha: library.couplings.alpha });
    expect(library.playback.frame).toBe(frame + TRANSITION_FRAMES);
  });

  it("applies the newest couplings and tempos", async () => {
    await opened();
    for (const alpha of [5, 6, 7]) library.couplings.set(0, 1, alpha);
    expect(library.couplings.weight(0, 1)).toBeCloseTo(
      1 / 7 / (1 / 7 + 1 / library.couplings.alphaOf(1, 1)),
      12,
    );
    library.setTempo(1, 1.2);
    library.setTempo(1, 1.3);
    library.setTempo(0, 0.9);
    await pass(1);
    const [forth, back] = library.couplings.learned;
    const couplings = [[forth?.[0], 7], back];
    expect(changes()).toEqual([
      { kind: "couplings", alpha: couplings, reading: "as-learned" },
      { kind: "tempo", part: 1, tempo: 1.3 },
      { kind: "tempo", part: 0, tempo: 0.9 },
    ]);
    expect(JSON.parse(await library.combinationText())).toMatchObject({ alpha: couplings });
    expect(workers.asked("combinationText")).toEqual([[[0, 3], couplings]]);
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
    await expect(library.add(armsText("clap", 2))).rejects.toThrow("the pose maps of upper differ");
    expect(library.current?.info.primitives).toHaveLength(5);
    await library.openFile(libraryText(5), "mine.json");
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
    await library.open(libraryText(4), "The library learned here", true);
    expect(library.isCombinationSaved).toBe(false);
    library.save();
    expect(library.isCombinationSaved).toBe(true);
  });

  it("reports when it stops", async () => {
    await opened();
    workers.answer("advanceWalk", () => Promise.reject(new Error("no longer finite")));
    await pass(0.3);
    expect(library.walk.track).toBeNull();
    expect(notices.all.at(-1)?.title).toBe("The live motion has ended");
  });
});
