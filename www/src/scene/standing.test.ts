import { expect, it } from "vitest";
import { headingOf } from "./standing";

/** A single node that moves by this much a frame. */
const walk = (dx: number, dz: number) => ({
  positions: Float32Array.from({ length: 90 }, (_, i) => [dx, 0, dz][i % 3]! * Math.floor(i / 3)),
  frames: 30,
  nodes: 1,
  frameTime: 1 / 30,
});

it("finds the direction of a walk", () => {
  expect(headingOf(walk(0, 0.1))).toBeCloseTo(0);
  expect(headingOf(walk(0.1, 0))).toBeCloseTo(Math.PI / 2);
  expect(headingOf(walk(-0.1, -0.1))).toBeCloseTo(-0.75 * Math.PI);
});

it("finds none in a figure that stays in its place", () => {
  expect(headingOf(walk(0.001, 0.001))).toBe(0);
});
