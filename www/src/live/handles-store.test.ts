import { beforeEach, expect, it, vi } from "vitest";
import type { ByHand, Drag, MadeMotion } from "../engine/whole-protocol";
import { Playback } from "../stage/playback";
import { HandlesStore } from "./handles-store";

/** A root, a hand on each side of it, and a foot, 10 frames. */
const POSE = [0, 1, 0, 0.5, 1, 0, -0.7, 1.1, 0, 0.9, 0, 0];
const made = (handles: ByHand, alpha: number[][] = []): MadeMotion => ({
  kind: "dmp-rhythmic",
  figure: { nodes: POSE.slice(0, 4).map(() => ({ joint: 0, parent: null, endSite: false })) },
  joints: [],
  parts: [],
  motion: {
    positions: new Float32Array(Array.from({ length: 10 }, () => POSE).flat()),
    frames: 10,
    nodes: 4,
    frameTime: 0.1,
  },
  bvh: "",
  handles,
  alpha,
});

const ALPHA = [
  [1, 2],
  [3, 4],
];

let playback: Playback;
let asked: [ByHand, Drag?][];
let isShown: boolean;
let handles: HandlesStore;
beforeEach(() => {
  [playback, asked, isShown] = [new Playback(), [], true];
  const roll = async (before: ByHand, drag?: Drag) => {
    asked.push([before, drag]);
    return made(drag ? { ...before, push: { frame: drag.frame, by: [1] } } : before);
  };
  const first = made({});
  playback.load(first.motion, { whole: true, goesOn: false });
  playback.seek(4.4);
  handles = new HandlesStore(playback, first, () => isShown, roll, vi.fn(), vi.fn());
});

it("holds the figure in the frame of a drag, and plays on when it is let go", async () => {
  playback.play();
  handles.reach(1, [0, 0.2, 0]);
  expect([playback.playing, playback.frame]).toEqual([false, 4]);
  await vi.waitFor(() => expect(handles.isAsLearned).toBe(false));
  // The drag goes on from the handles before it.
  handles.reach(1, [0, 0.3, 0]);
  await vi.waitFor(() => expect(asked).toHaveLength(2));
  const [before, drag] = asked[1]!;
  expect(before).toEqual({});
  expect(drag).toMatchObject({ frame: 4, node: 1, changes: "pose" });
  expect(drag!.place[1]).toBeCloseTo(0.3);
  handles.letGo();
  expect(playback.playing).toBe(true);
});

it("keeps a push while the tempo changes, and forgets both", async () => {
  handles.choose("goal");
  handles.lift();
  await vi.waitFor(() => expect(handles.isAsLearned).toBe(false));
  // The hand that is farther from the root; a foot is no hand.
  expect(asked[0]![1]).toMatchObject({ node: 2, changes: "goal" });
  handles.tempo = 0.5;
  await vi.waitFor(() => expect(handles.tempo).toBe(0.5));
  expect(asked[1]![0]).toMatchObject({ tempo: 0.5, push: { frame: 4 } });
  // Also while the motion of a drag is on its way.
  handles.lift();
  handles.tempo = 0.75;
  await vi.waitFor(() => expect(handles.tempo).toBe(0.75));
  expect(asked.at(-1)).toMatchObject([{ tempo: 0.75 }, { node: 2, changes: "goal" }]);
  // A drag keeps a tempo whose motion is on its way.
  handles.tempo = 1.5;
  handles.lift();
  await vi.waitFor(() => expect(asked.at(-1)).toMatchObject([{ tempo: 1.5 }, { node: 2 }]));
  handles.reset();
  await vi.waitFor(() => expect(handles.isAsLearned).toBe(true));
});

it("changes the couplings of a MAP CGPDM, which has no limbs to drag", async () => {
  const roll = vi.fn(async (now: ByHand) => made(now, ALPHA));
  const store = new HandlesStore(playback, made({}, ALPHA), () => true, roll, vi.fn(), vi.fn());
  expect([store.running, store.isAsLearned]).toEqual([false, true]);
  store.couplings.set(0, 1, 8);
  expect(roll).toHaveBeenLastCalledWith({ alpha: [[1, 8], ALPHA[1]] }, undefined);
  expect(store.isAsLearned).toBe(false);
  store.reset();
  await vi.waitFor(() => expect(roll).toHaveBeenLastCalledWith({}, undefined));
  expect(store.isAsLearned).toBe(true);
});

it("has no limbs to drag while another motion is on the stage", () => {
  isShown = false;
  expect(handles.running).toBe(false);
});
