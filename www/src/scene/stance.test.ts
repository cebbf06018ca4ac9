import { describe, expect, it } from "vitest";
import { headingOf, MIDDLE, viewOf } from "./stance";

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

describe("the view of a motion", () => {
  // A root that walks along x, and a limb that reaches this high and this far.
  const swing = (height: number, aside: number) => {
    const positions = new Float32Array([0, 1, 0, 0, 0, 0, 5, 1, 0, 5, height, aside]);
    return { positions, frames: 2, nodes: 2, frameTime: 1 / 30 };
  };
  const slope = Math.tan((15 * Math.PI) / 180);

  it("shows feet and raised hands, from every side", () => {
    for (const aspect of [0.6, 1.6]) {
      const { middle, distance } = viewOf(swing(2.2, 1), 0, { slope, aspect });
      expect((2.2 - middle) / (distance - 1)).toBeLessThan(slope);
      expect(middle / (distance - 1)).toBeLessThan(slope);
      expect(1 / distance).toBeLessThan(slope * aspect);
    }
  });

  it("is nearer and lower for arms that hang", () => {
    const [low, high] = [0.2, 2.2].map((height) => viewOf(swing(height, 0.5), 0, { slope, aspect: 1.6 }));
    expect(low!.middle).toBeCloseTo(MIDDLE);
    expect(low!.middle).toBeLessThan(high!.middle);
    expect(low!.distance).toBeLessThan(high!.distance);
  });

  it("leaves space for a figure that is moved down in the picture", () => {
    const shift = 0.06;
    const { middle, distance } = viewOf(swing(1.8, 0.2), 0, { slope, aspect: 1.6, shift });
    expect(middle / distance / slope / 2).toBeLessThan(0.5 - shift);
  });
});
