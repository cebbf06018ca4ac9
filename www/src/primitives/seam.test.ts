import { expect, it } from "vitest";
import { SEAM_FRAMES, Seam } from "./seam";

/** One node that moves on by `step` a frame from `from`. */
const line = (from: number, step: number, frames: number) =>
  Float32Array.from({ length: 3 * frames }, (_, i) => from + step * Math.floor(i / 3));
const xOf = (positions: Float32Array) => [...positions].filter((_, i) => i % 3 === 0);

it("lets nothing through but what it is given, without a change", () => {
  const seam = new Seam();
  const positions = line(1, 0.1, 5);
  seam.pass(positions, 5);
  expect([...positions]).toEqual([...line(1, 0.1, 5)]);
});

it("lets a jump fade away: no step is much larger than the jump spread over the seam, and nothing is left of it", () => {
  const seam = new Seam();
  const before = line(0, 0.01, 10);
  const after = line(1, 0.01, 30);
  seam.pass(before, 10);
  seam.open();
  // The frames come in pieces, as they do while the figure walks.
  for (let k = 0; k < 10; k++) seam.pass(after.subarray(9 * k, 9 * k + 9), 3);
  const all = [...xOf(before), ...xOf(after)];
  const steps = all.slice(1).map((x, i) => Math.abs(x - (all[i] ?? 0)));
  expect(Math.max(...steps)).toBeLessThan(0.01 + (1.6 * 1) / SEAM_FRAMES);
  expect(all.at(-1)).toBeCloseTo(1.29, 5);
  expect(steps.at(-1)).toBeCloseTo(0.01, 5);
});

it("has nothing to bridge before two frames are there", () => {
  const seam = new Seam();
  seam.open();
  const positions = line(3, 0, 2);
  seam.pass(positions, 2);
  expect(xOf(positions)).toEqual([3, 3]);
});
