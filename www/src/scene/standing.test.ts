import { expect, it } from "vitest";
import { distanceFor, headingOf, reachOf } from "./standing";

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

it("finds how far a figure reaches, and a camera far enough away to see all of it", () => {
  // A root that walks along x, and a foot that swings over it, a metre aside at 2.2 metres.
  const positions = new Float32Array([0, 1, 0, 0, 0, 0, 5, 1, 0, 5, 2.2, 1]);
  const reach = reachOf({ positions, frames: 2, nodes: 2, frameTime: 1 / 30 }, 0);
  expect(reach.up).toBeCloseTo(2.2);
  expect(reach.out).toBeCloseTo(1);
  const slope = Math.tan((15 * Math.PI) / 180);
  for (const aspect of [0.6, 1.6]) {
    const away = distanceFor(reach, slope, aspect);
    // The foot at its nearest to the camera is within the picture.
    expect((reach.up - 0.88) / (away - reach.out)).toBeLessThan(slope);
    expect(reach.out / away).toBeLessThan(slope * aspect);
  }
  expect(distanceFor({ up: 1.7, out: 0.6 }, slope, 1.3)).toBeLessThan(distanceFor(reach, slope, 1.3));
});
