import { expect, it } from "vitest";
import { deviationsFrom, scorePin, spreadOf } from "./pin";

/** Wide in the first direction, narrow in the second. */
const places: [number, number][] = [
  [-2, 0],
  [2, 0],
  [0, -0.5],
  [0, 0.5],
];

it("measures a distance in standard deviations of its direction", () => {
  const spread = spreadOf(places);
  expect(spread.mean).toEqual([0, 0]);
  expect(deviationsFrom(spread, [2, 0])).toBeCloseTo(2 / Math.sqrt(8 / 3), 12);
  expect(deviationsFrom(spread, [0, 0.5])).toBeCloseTo(deviationsFrom(spread, [2, 0]), 12);
});

it("counts the futures that are further from the mean than the pin", () => {
  expect(scorePin(places, [0, 0])).toEqual({ deviations: 0, beaten: 4, futures: 4 });
  expect(scorePin(places, [3, 0]).beaten).toBe(0);
});
