import { describe, expect, it } from "vitest";
import { principalAxes, project, symmetricEigen, turned } from "./projection";

/** An ellipse in a tilted plane of three dimensions. */
function ellipse(n: number, flip = 1): Float64Array {
  const points = new Float64Array(n * 3);
  for (let t = 0; t < n; t++) {
    const angle = (2 * Math.PI * t) / n;
    const [u, v] = [3 * Math.cos(angle), flip * Math.sin(angle)];
    points.set([5 + 0.6 * u, 0.8 * u - 1, v], t * 3);
  }
  return points;
}

describe("principal axes", () => {
  it("finds the long and the short axis of an ellipse", () => {
    const { axes, centre, reach } = principalAxes(ellipse(60), 3);
    expect([...centre].map((value) => Math.round(value))).toEqual([5, -1, 0]);
    expect(Math.abs(axes[0]! * 0.6 + axes[1]! * 0.8)).toBeCloseTo(1, 10);
    expect(Math.abs(axes[5]!)).toBeCloseTo(1, 10);
    expect(reach).toBeCloseTo(3, 10);
  });

  it("keeps its signs when fitted again", () => {
    const before = principalAxes(ellipse(60), 3);
    before.axes = before.axes.map((value) => -value);
    const after = principalAxes(ellipse(60), 3, before);
    const [a, b] = [new Float64Array(3), new Float64Array(3)];
    project(before, ellipse(60), 7, a);
    project(after, ellipse(60), 7, b);
    for (const [k, value] of a.entries()) expect(b[k]).toBeCloseTo(value, 8);
  });

  it("accepts one dimension, more than three, and equal points", () => {
    expect(principalAxes(new Float64Array([1, 2, 3]), 1).axes[0]).toBe(1);
    const many = principalAxes(
      Float64Array.from({ length: 50 }, (_, i) => Math.sin(i * i)),
      5,
    );
    expect([...many.axes].every(Number.isFinite)).toBe(true);
    expect(principalAxes(new Float64Array(9), 3).reach).toBe(1);
    expect(principalAxes(new Float64Array(0), 3).reach).toBe(1);
  });
});

describe("eigenvectors", () => {
  it("rebuild the matrix", () => {
    const m = new Float64Array([4, 1, -2, 1, 3, 0.5, -2, 0.5, 1]);
    const { values, vectors } = symmetricEigen(m, 3);
    for (let i = 0; i < 3; i++) {
      for (let j = 0; j < 3; j++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) sum += vectors[i * 3 + k]! * values[k]! * vectors[j * 3 + k]!;
        expect(sum).toBeCloseTo(m[i * 3 + j]!, 10);
      }
    }
  });
});

describe("turning", () => {
  it("keeps lengths, and changes nothing without a rotation", () => {
    const point = new Float64Array([1, 2, 3]);
    expect(turned(point, { about: 0, tilt: 0 })).toEqual([1, 2, 3]);
    expect(Math.hypot(...turned(point, { about: 1, tilt: -0.4 }))).toBeCloseTo(Math.hypot(1, 2, 3), 10);
  });
});
