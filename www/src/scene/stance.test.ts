import { expect, it } from "vitest";
import { distanceFor, headingOf } from "./stance";

/** A single node that moves by this distance in each frame. */
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

it("finds no direction in a walk on the spot", () => {
  expect(headingOf(walk(0.001, 0.001))).toBe(0);
});

it("finds a distance from which a camera sees all of a motion", () => {
  // A root that walks along x, and a foot that swings above it.
  const swing = (height: number, aside: number) => {
    const positions = new Float32Array([0, 1, 0, 0, 0, 0, 5, 1, 0, 5, height, aside]);
    return { positions, frames: 2, nodes: 2, frameTime: 1 / 30 };
  };
  const slope = Math.tan((15 * Math.PI) / 180);
  for (const aspect of [0.6, 1.6]) {
    const away = distanceFor(swing(2.2, 1), 0, slope, aspect);
    expect((2.2 - 0.88) / (away - 1)).toBeLessThan(slope);
    expect(1 / away).toBeLessThan(slope * aspect);
    expect(distanceFor(swing(0.2, 0.5), 0, slope, aspect)).toBeLessThan(away);
  }
});
