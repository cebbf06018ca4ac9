import { expect, it } from "vitest";
import { ellipseOf, Plane } from "./plane";
import { momentsAt, trailTimes } from "./outlook-drawing";

it("draws the last half second, within the frames of the motion", () => {
  expect(trailTimes(0, 100)).toEqual([0]);
  expect(trailTimes(2.5, 100)).toEqual([0, 1, 2, 2.5]);
  expect(trailTimes(50, 100)).toEqual([...Array.from({ length: 15 }, (_, i) => 35 + i), 50]);
  expect(trailTimes(12, 3)).toEqual([0, 1, 2, 3]);
});

it("reads the Gaussian at a time from means and covariances", () => {
  const projection = {
    centre: new Float64Array(2),
    axes: Float64Array.of(1, 0, 0, 1, 0, 0),
    reach: 1,
    flat: [1, 1] as [number, number],
    dimensions: 2,
  };
  const plane = new Plane({ width: 100, height: 100, projection, turn: { about: 0, tilt: 0 } });
  const moments = {
    means: Float64Array.of(0, 0, 1, 0),
    covariances: Float64Array.of(0, 0, 0, 0, 2, 0, 0, 8),
  };
  const { x, y, spread } = momentsAt(plane, moments, 0.5);
  expect([x, y]).toEqual([50 + 0.5 * 41, 50]);
  const { major, minor } = ellipseOf([x, y], spread);
  expect([major, minor]).toEqual([expect.closeTo(2 * 41, 8), expect.closeTo(41, 8)]);
});
