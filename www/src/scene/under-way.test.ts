import { expect, it } from "vitest";
import { underWay } from "./under-way";

/** Two frames of two nodes: one in the middle, one a metre ahead of it and one to its left. */
const motion = {
  positions: new Float32Array([0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]),
  frames: 2,
  nodes: 2,
  frameTime: 0.5,
};
const rounded = (values: Iterable<number>) => [...values].map((value) => Math.round(1000 * value) / 1000 + 0);

it("a movement crosses the ground in its heading, and the camera follows", () => {
  const ahead = underWay(motion, 2, 0);
  expect(rounded(ahead.motion.positions)).toEqual([0, 1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 2]);
  expect(ahead.camera).toEqual({ x: 0, z: 2 });
  const aside = underWay(motion, 2, Math.PI / 2);
  expect(rounded(aside.motion.positions)).toEqual([0, 1, 0, 1, 0, -1, 1, 1, 0, 2, 0, -1]);
  expect(rounded(Object.values(aside.camera ?? {}))).toEqual([2, 0]);
  expect(rounded(motion.positions)).toEqual([0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]);
});
