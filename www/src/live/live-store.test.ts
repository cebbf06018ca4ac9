import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { modelText } from "../engine/documents.fake";
import type { LiveChange } from "../engine/protocol";
import { startModel } from "../engine/start-model.fake";
import { fromRoot } from "../scene/motion";
import type { LiveStore } from "./live-store";
import { modelLive } from "./model-live";

/** It walks at 30 frames a second. */
const { text, info } = await startModel();
const NODE = info.figure.nodes.findIndex(({ joint }) => joint === info.parts[1]!.joints.at(-1));

let { workers, store, playback, stage, notices, model } = new HeldLab();
let live: LiveStore;

beforeEach(async () => {
  const lab = new HeldLab();
  ({ workers, store, playback, stage, notices, model } = lab);
  await lab.start(text, { couplings: "link", clip: false });
  live = modelLive({ ...lab, engine: lab.store });
});

/** Lets seconds of the visitor's time pass, with this many pictures a second. */
async function pass(seconds: number, pictures = 60): Promise<void> {
  for (let k = 0; k < seconds * pictures; k++) {
    playback.advance(1 / pictures);
    await workers.settled();
  }
}

const steps = () => workers.asked("advanceLive").map(([step]) => step);
/** The changes in the frames that were not taken back. */
function changes(): LiveChange[] {
  let [last, made]: [number, { after: number; change: LiveChange }[]] = [0, []];
  for (const { back, changes, frames } of steps()) {
    last -= back;
    if (back > 0) made = made.filter(({ after }) => after < last);
    for (const change of changes) made.push({ after: last, change });
    last += frames;
  }
  return made.map(({ change }) => change);
}

describe("a live rollout", () => {
  it("ends when another motion takes the stage", async () => {
    await live.start();
    stage.endLive();
    expect(live.running).toBe(false);
  });

  it("continues with a model that replaced the first one during the start", async () => {
    workers.hold("advanceLive");
    const begun = live.start();
    await workers.settled();
    await model.open(modelText(2));
    workers.letGo("advanceLive");
    workers.held("advanceLive")[0]!.go();
    await begun;
    expect(live.running).toBe(true);
    // Another change of couplings does not end it.
    model.couplings.set(0, 1, 9);
    expect(live.running).toBe(true);
  });

  it("takes a change that comes while it begins", async () => {
    workers.hold("advanceLive");
    const begun = live.start();
    await workers.settled();
    live.change({ kind: "cut", source: 0, target: 1, cut: true });
    workers.letGo("advanceLive");
    workers.held("advanceLive")[0]!.go();
    await begun;
    await pass(0.5);
    expect(changes().at(-1)).toEqual({ kind: "cut", source: 0, target: 1, cut: true });
  });

  it("takes no frames of a motion that was ended", async () => {
    await live.start();
    workers.hold("advanceLive");
    await pass(0.3);
    const held = workers.held("advanceLive");
    expect(held).toHaveLength(1);
    const end = await held[0]!.late();
    const told = vi.fn();
    live.on(told);
    live.stop();
    expect(told).toHaveBeenCalled();
    workers.letGo("advanceLive");
    await live.start();
    const frames = () => [live.track?.last, ...live.trace.map(({ frame }) => frame)];
    const before = frames();
    end();
    await workers.settled();
    expect(frames()).toEqual(before);
    // Nor does its error end the new motion.
    workers.hold("advanceLive");
    await pass(0.3);
    live.stop();
    workers.letGo("advanceLive");
    await live.start();
    workers.held("advanceLive")[1]!.fail(new Error("late"));
    await workers.settled();
    expect([live.running, notices.all]).toEqual([true, []]);
  });

  it("begins at the state of the figure, has no end, and gives the motion of some seconds back", async () => {
    playback.scrub(40);
    await live.start();
    expect(stage.content?.live).toBe(true);
    expect(playback.playing).toBe(true);
    await pass(14, 15);
    expect(playback.frame).toBeGreaterThan(13 * 30);
    // The stored seconds do not grow.
    expect(live.trace.length).toBeLessThanOrEqual(12 * 30);
    expect(live.track?.latents(0)).toHaveLength(3 * (live.track?.motion.frames ?? 0));
    live.stop();
    await workers.settled();
    expect(stage.content?.live).toBeUndefined();
    expect(workers.asked("endLive")).toHaveLength(1);
    expect(playback.frame).toBeLessThan(playback.lastFrame + 1);
  });

  it("cuts a coupling while it is held", async () => {
    await live.hold(0, 1, true);
    expect(live.running).toBe(true);
    expect(live.isCut(0, 1)).toBe(true);
    await pass(1);
    await live.hold(0, 1, false);
    await pass(1);
    expect(changes().slice(1)).toEqual([
      { kind: "cut", source: 0, target: 1, cut: true },
      { kind: "cut", source: 0, target: 1, cut: false },
    ]);
    const [mark] = live.marks;
    expect(mark?.kind === "cut" && (mark.to ?? 0) - mark.from).toBeGreaterThan(20);
  });

  it("cuts in the reading that the visitor has chosen, also while no coupling is changed", async () => {
    await live.hold(0, 1, true);
    const { alpha } = model.couplings;
    expect(changes()[0]).toEqual({ kind: "couplings", alpha, reading: "re-inferred" });
    model.couplings.setReading("as-learned");
    await pass(0.5);
    expect(changes().at(-1)).toEqual({ kind: "couplings", alpha, reading: "as-learned" });
  });

  it("keeps the last coupling into a part", async () => {
    await live.hold(0, 1, true);
    await live.hold(1, 1, true);
    expect(live.isCut(1, 1)).toBe(false);
    expect(notices.all.at(-1)?.title).toBe("This coupling stays");
  });

  it("uses the newest couplings, and marks one push for a drag", async () => {
    await live.start();
    model.couplings.set(0, 1, 9);
    model.couplings.set(0, 1, 20);
    await workers.settled();
    live.pull(NODE, [0.1, 0, 0]);
    live.pull(NODE, [0.1, 0, 0]);
    live.push(0, [0.5, 0, 0]);
    await pass(0.5);
    const made = changes().slice(1);
    expect(made.filter(({ kind }) => kind === "couplings")).toHaveLength(1);
    expect(made[0]).toMatchObject({ alpha: [[info.alpha[0]![0], 20], info.alpha[1]] });
    expect(made.filter(({ kind }) => kind === "pull")).toHaveLength(2);
    expect(live.marks.map((mark) => mark.kind === "push" && mark.part)).toEqual([1, 0]);
  });

  it("drives a part by the sum of its turns until it is released, and asks for fewer frames ahead", async () => {
    live.drive(0, 0.1);
    expect(live.driven).toBeNull();
    await live.start();
    await pass(0.5);
    const ahead = () => (live.track?.last ?? 0) - playback.frame;
    expect(ahead()).toBeGreaterThan(2.4);
    live.drive(0, 0);
    live.drive(0, 0.25);
    live.drive(0, -0.125);
    expect(live.driven).toBe(0);
    await pass(0.5);
    expect(ahead()).toBeLessThan(1.6);
    live.drive(1, 0.5);
    expect(live.driven).toBe(1);
    await pass(0.1);
    live.release(1);
    live.release(1);
    expect(live.driven).toBeNull();
    await pass(0.1);
    const made = changes().slice(1);
    expect(made).toEqual([
      // The first is on its way when the others come.
      { kind: "drive", part: 0, turns: 0 },
      { kind: "drive", part: 0, turns: 0.125 },
      { kind: "release", part: 0 },
      { kind: "drive", part: 1, turns: 0.5 },
      { kind: "release", part: 1 },
    ]);
    expect(live.marks.map((mark) => mark.kind === "drive" && mark.to !== null && mark.part)).toEqual([0, 1]);
  });

  it("answers a turn with a new frame at once, in place of one that the figure has not reached", async () => {
    await live.start();
    live.drive(0, 0);
    await pass(0.5);
    const frames = () => [...live.trace.map(({ frame }) => frame)];
    let turned = 0;
    for (let turn = 0; turn < 20; turn++) {
      const [shown, last] = [playback.frame, live.track?.last ?? 0];
      live.drive(0, 0.01);
      await workers.settled();
      const step = steps().at(-1);
      expect(step?.back).toBe(last - Math.floor(shown));
      expect(step?.changes.at(-1)).toEqual({ kind: "drive", part: 0, turns: 0.01 });
      // The new frame is the next one of the picture, also of a picture at 60 a second.
      expect(live.track?.last).toBeGreaterThanOrEqual(Math.floor(shown) + 1);
      turned += 0.01;
      expect(frames()).toEqual(frames().map((_, k) => (frames()[0] ?? 0) + k));
      await pass(1 / 60);
    }
    expect(playback.frame).toBeGreaterThan(20);
    // No turn is lost or counted twice.
    const turns = changes().map((change) => (change.kind === "drive" ? change.turns : 0));
    expect(turns.reduce((sum, turn) => sum + turn)).toBeCloseTo(turned);
  });

  it("lets a recording move a part, with the recording as an outline, until another mover takes the part", async () => {
    const { motion, latents } = model.rollout!;
    const recording = { key: "a", title: "Walk", latents: latents[0]!, motion };
    live.record(0, recording);
    expect(live.moverOf(0)).toBeNull();
    await live.start();
    live.record(0, recording);
    expect([live.moverOf(0)?.kind, live.moverOf(1), stage.ghost]).toEqual(["record", null, motion]);
    // The outline begins with the first frame that the recording moves.
    expect(stage.ghostFrame).toBeNull();
    await pass(0.5);
    const before = stage.ghostFrame!;
    await pass(0.5);
    expect(stage.ghostFrame! - before).toBeCloseTo(15, 0);
    // The other part stays free, and couplings into it can be cut.
    await live.hold(0, 1, true);
    await live.hold(0, 1, false);
    live.drive(0, 0);
    expect([live.moverOf(0)?.kind, live.driven, stage.ghost]).toEqual(["drive", 0, null]);
    live.record(0, recording);
    const told = vi.fn();
    const stop = live.on(told);
    live.release(0);
    stop();
    expect(told).toHaveBeenCalled();
    await pass(0.5);
    expect([live.moverOf(0), stage.ghost, stage.ghostFrame]).toEqual([null, null, null]);
    const made = changes().slice(1);
    expect(made.map(({ kind }) => kind)).toEqual([...["record", "cut", "drive", "record", "release"]]);
    expect(live.marks.map((mark) => [mark.kind, mark.kind !== "push" && mark.to !== null])).toEqual([
      ["record", true],
      ["cut", true],
      ["drive", true],
      ["record", true],
    ]);
    live.record(1, recording);
    live.stop();
    expect(stage.ghost).toBeNull();
  });

  it("lets a part follow a dragged node, relative to the root, and marks it as one push", async () => {
    await live.start();
    const place = fromRoot(playback.pose!, NODE, [0.25, 0, 0]);
    for (const by of [0.5, 0.3, 0.25]) live.reach(NODE, [by, 0, 0]);
    expect([live.moverOf(1)?.kind, live.driven]).toEqual(["push", null]);
    await pass(0.5);
    // Only the newest place matters, although an earlier one was on its way.
    const reached = changes().filter(({ kind }) => kind === "reach");
    const back = live.track!.turnedBack(place).map((metres): unknown => expect.closeTo(metres, 5));
    expect(reached).toEqual([{ kind: "reach", node: NODE, place: back }]);
    const [mark] = live.marks;
    expect(mark?.kind === "push" && mark.from - mark.began).toBeGreaterThan(3);
    live.letGo(NODE);
    live.letGo(NODE);
    const from = mark?.kind === "push" ? mark.from : 0;
    await pass(0.5);
    expect(live.marks).toEqual([
      { kind: "push", part: 1, began: expect.any(Number) as number, from, held: false },
    ]);
    expect(changes().at(-1)).toEqual({ kind: "release", part: 1 });
  });

  it("ends with a clip on the stage, with another model, and when the model cannot go on", async () => {
    await live.start();
    stage.showClip({
      kind: "clip",
      clip: "a",
      figure: { nodes: [] },
      joints: [],
      parts: [],
      motion: { positions: new Float32Array(60), frames: 10, nodes: 2, frameTime: 0.1 },
    });
    expect(live.running).toBe(false);
    await live.start();
    expect(stage.clip).toBeNull();
    await model.open(modelText(2, 1, 30));
    expect(live.running).toBe(false);
    await live.start();
    await store.engine!.endLive();
    await pass(0.3);
    expect(live.running).toBe(false);
    expect(notices.all.at(-1)?.title).toBe("The live motion has ended");
  });
});
