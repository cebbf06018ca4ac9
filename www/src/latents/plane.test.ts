import { describe, expect, it } from "vitest";
import { deviationAcross, ellipseOf, Plane } from "./plane";
import { principalAxes, type Turn } from "./projection";

/** A plot whose axes are those of the latent space, with 41 pixels for 1. */
function plane(q: number, turn: Turn = { about: 0, tilt: 0 }): Plane {
  const axes = new Float64Array(3 * q);
  for (let k = 0; k < Math.min(3, q); k++) axes[k * q + k] = 1;
  const projection = {
    centre: new Float64Array(q),
    axes,
    reach: 1,
    flat: [1, 1] as [number, number],
    dimensions: q,
  };
  return new Plane({ width: 100, height: 200, projection, turn });
}

describe("a Gaussian in a plot", () => {
  it("is a circle with the radius of its deviation, from every side of three equal dimensions", () => {
    for (const turn of [
      { about: 0, tilt: 0 },
      { about: 1.1, tilt: -0.7 },
    ]) {
      const { x, y, major, minor } = ellipseOf(
        plane(3, turn).place(new Float64Array(3), 0),
        plane(3, turn).roundSpread(0.25),
      );
      expect([x, y]).toEqual([50, 100]);
      expect(major).toBeCloseTo(0.5 * 41, 10);
      expect(minor).toBeCloseTo(0.5 * 41, 10);
    }
  });

  it("is a circle in the principal axes of five dimensions", () => {
    const points = Float64Array.from({ length: 100 }, (_, i) => Math.sin(i * i));
    const projection = principalAxes(points, 5);
    const seen = new Plane({
      width: 100,
      height: 100,
      projection,
      turn: { about: 0.4, tilt: 0.2 },
    }).roundSpread(4);
    const { major, minor } = ellipseOf([0, 0], seen);
    expect(major).toBeCloseTo((2 * 41) / projection.reach, 8);
    expect(minor).toBeCloseTo(major, 8);
  });

  it("is a disc seen from the side in two dimensions, and a line in one", () => {
    const { major, minor } = ellipseOf([0, 0], plane(2, { about: 0, tilt: Math.PI / 3 }).roundSpread(1));
    expect([major, minor / major]).toEqual([expect.closeTo(41, 10), expect.closeTo(0.5, 10)]);
    const line = ellipseOf([0, 0], plane(1).roundSpread(1));
    expect([line.major, line.minor, line.angle]).toEqual([expect.closeTo(41, 10), 0, 0]);
  });

  it("is an ellipse along its longest deviation, where dimensions differ", () => {
    // The longest deviation is along the diagonal, which goes up on the page.
    const covariances = Float64Array.of(
      9,
      9,
      9,
      1,
      0,
      0,
      0,
      1,
      0,
      0,
      0,
      1,
      2.5,
      1.5,
      0,
      1.5,
      2.5,
      0,
      0,
      0,
      7,
    );
    const seen = plane(3).spread(covariances.slice(3), 1);
    const { major, minor, angle } = ellipseOf([0, 0], seen);
    expect(major).toBeCloseTo(2 * 41, 8);
    expect(minor).toBeCloseTo(41, 8);
    expect(angle).toBeCloseTo(-Math.PI / 4, 8);
    expect(deviationAcross(seen, 1, -1)).toBeCloseTo(41, 8);
    expect(deviationAcross(seen, 1, 1)).toBeCloseTo(2 * 41, 8);
    expect(deviationAcross(seen, 0, 0)).toBe(0);
  });
});

describe("a step in a plot", () => {
  it("is the latent step that looks the same", () => {
    for (const turn of [
      { about: 0, tilt: 0 },
      { about: 1.1, tilt: -0.7 },
    ]) {
      const plot = plane(3, turn);
      const by = plot.latentStep(7, -4);
      const [x, y, near] = plot.place(Float64Array.from(by), 0);
      expect([x, y, near]).toEqual([expect.closeTo(57, 10), expect.closeTo(96, 10), expect.closeTo(0, 10)]);
    }
  });

  it("has no part in an invisible dimension", () => {
    expect(plane(1).latentStep(41, 41)).toEqual([1]);
    // The plane of the two dimensions is seen from its edge: a drag upwards moves nothing.
    const [right, up] = plane(2, { about: 0, tilt: Math.PI / 2 }).latentStep(41, -41);
    expect([right, up]).toEqual([expect.closeTo(1, 10), expect.closeTo(0, 10)]);
  });
});

describe("the scale of a plot", () => {
  it("lets a flat cloud fill the plot, and keeps a turned cloud within it", () => {
    const circle = (points: number, height: number) =>
      Float64Array.from({ length: 2 * points }, (_, i) =>
        i % 2 === 0 ? 3 * Math.cos((Math.PI * i) / points) : height * Math.sin((Math.PI * (i - 1)) / points),
      );
    const farthest = (height: number, turn: Turn) => {
      const points = circle(40, height);
      const plot = new Plane({ width: 200, height: 100, projection: principalAxes(points, 2), turn });
      const places = Array.from({ length: 40 }, (_, i) => plot.place(points, i));
      return [Math.max(...places.map(([x]) => x)), Math.max(...places.map(([, y]) => y))];
    };
    const flat = { about: 0, tilt: 0 };
    // A flat cloud fills 41 % of the width, a round one 41 % of the height.
    expect(farthest(1, flat)[0]).toBeCloseTo(100 + 82, 6);
    expect(farthest(2.9, flat)[1]).toBeCloseTo(50 + 41, 6);
    expect(farthest(1, { about: 0.01, tilt: 0 })[0]).toBeLessThan(100 + 41);
  });
});

describe("a mark beyond the plot", () => {
  it("is drawn at the edge of the plot, other marks at their places", () => {
    const plot = plane(2);
    expect(plot.inFrame(50, 60)).toEqual([50, 60]);
    expect(plot.inFrame(-30, 400)).toEqual([7, 193]);
  });
});
