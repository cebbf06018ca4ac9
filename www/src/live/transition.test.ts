import { expect, it } from "vitest";
import { extrapolated, TRANSITION_FRAMES, Transition } from "./transition";

/** One node that starts at `from` and moves by `step` in each frame. */
const line = (from: number, step: number, frames: number) =>
  Float32Array.from({ length: 3 * frames }, (_, i) => from + step * Math.floor(i / 3));
const xOf = (positions: Float32Array) => [...positions].filter((_, i) => i % 3 === 0);

it("does not change frames without a transition", () => {
  const seam = new Transition();
  const positions = line(1, 0.1, 5);
  seam.apply(positions, 5, 0);
  expect([...positions]).toEqual([...line(1, 0.1, 5)]);
});

it("spreads a jump over the transition, and nothing is left of it", () => {
  const seam = new Transition();
  const before = line(0, 0.01, 10);
  const after = line(1, 0.01, 30);
  seam.start(10, after.slice(0, 3), extrapolated(before.subarray(24, 27), before.subarray(27)));
  // The frames arrive in pieces, as during a walk.
  for (let k = 0; k < 10; k++) seam.apply(after.subarray(9 * k, 9 * k + 9), 3, 10 + 3 * k);
  const all = [...xOf(before), ...xOf(after)];
  const steps = all.slice(1).map((x, i) => Math.abs(x - (all[i] ?? 0)));
  expect(Math.max(...steps)).toBeLessThan(0.01 + (1.6 * 1) / TRANSITION_FRAMES);
  // The first frame starts the transition.
  expect(steps[9]).toBeGreaterThan(0.015);
  expect(all.at(-1)).toBeCloseTo(1.29, 5);
  expect(steps.at(-1)).toBeCloseTo(0.01, 5);
});

it("continues when frames are computed again", () => {
  const seam = new Transition();
  const [first, again] = [line(1, 0, 8), line(1, 0, 6)];
  seam.start(4, first.slice(0, 3), line(0, 0, 1));
  seam.apply(first, 8, 4);
  seam.apply(again, 6, 6);
  expect(xOf(again)).toEqual(xOf(first).slice(2));
});
