import { describe, expect, it } from "vitest";
import { curvePaths, frameOf, linePath } from "./paths";

describe("points of a plane", () => {
  it("fit into the drawing, as wide as they are high", () => {
    // Twice as wide as high.
    const points = [-2, 0, 2, 0, 0, 1, 0, -1];
    const frame = frameOf(points, 100);
    expect(frame.scale).toBeCloseTo(22);
    expect(linePath(points, frame)).toBe("M6 50L94 50L50 28L50 72");
  });

  it("at rest are in the middle, and an empty list makes no line", () => {
    expect(linePath([3, 4], frameOf([3, 4], 100))).toBe("M50 50");
    expect(linePath([], frameOf([], 100))).toBe("");
  });
});

describe("curves over time", () => {
  it("have a row each, one scale, and as many frames as asked for", () => {
    const paths = curvePaths({
      values: [1, 0, -1, 0.5, 9, 9],
      columns: 2,
      frames: 2,
      width: 100,
      height: 40,
    });
    expect(paths).toEqual(["M0 -6L100 26", "M0 30L100 22"]);
  });

  it("that are flat stay flat", () => {
    expect(curvePaths({ values: [0, 0, 0], columns: 1, frames: 3, width: 10, height: 10 })).toEqual([
      "M0 5L5 5L10 5",
    ]);
  });
});
