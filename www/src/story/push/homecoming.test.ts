import { expect, it } from "vitest";
import type { TracePoint } from "../../live/live-store";
import { homecoming, homeLimit } from "./push-chapter";

const FRAME = 1 / 30;
/** A walk that strays by 0.05, is pushed from frame 60 to 69, and then comes nearer by a tenth each frame. */
const walk = (frames: number, decay = 0.9): TracePoint[] =>
  Array.from({ length: frames }, (_, frame) => {
    const arms = frame < 60 ? 0.05 : frame < 70 ? 0.15 * (frame - 59) : 1.5 * decay ** (frame - 69);
    return { frame, phases: [0, 0], distances: [0.04, arms] };
  });
const push = { kind: "push" as const, part: 1, began: 60, from: 69 };

it("takes the settled walk before the push as the measure of home", () => {
  const start = { frame: 0, phases: [0, 0], distances: [0.6, 0.6] };
  const before = [...Array(30).fill(start), ...walk(60)];
  expect(homeLimit(before, FRAME)).toBeCloseTo(0.1);
  expect(homeLimit(before.slice(0, 60), FRAME)).toBeNull();
});

it("counts the seconds from the end of the push to the last frame away from home", () => {
  const { farthest, seconds, isLost } = homecoming(walk(150), push, 0.1, FRAME);
  expect(farthest).toBeCloseTo(1.5);
  // 1.5 * 0.9^k is below 0.1 from k = 26 on.
  expect(seconds).toBeCloseTo(26 * FRAME);
  expect(isLost).toBe(false);
});

it("waits for a second near the loop, because a part can swing through it", () => {
  expect(homecoming(walk(110), push, 0.1, FRAME).seconds).toBeNull();
  const through = walk(150).map((point) =>
    point.frame === 120 ? { ...point, distances: [0.04, 0.3] } : point,
  );
  expect(homecoming(through, push, 0.1, FRAME).seconds).toBeNull();
});

it("calls a walk lost that does not come home, or another part of it", () => {
  expect(homecoming(walk(400, 1), push, 0.1, FRAME)).toMatchObject({ seconds: null, isLost: true });
  const legs = walk(400).map((point) => ({ ...point, distances: [0.5, 0.01] }));
  expect(homecoming(legs, push, 0.1, FRAME).isLost).toBe(true);
});

it("knows nothing of the frames before they have arrived", () => {
  expect(homecoming(walk(60), push, 0.1, FRAME)).toEqual({ farthest: 0, seconds: null, isLost: false });
});
