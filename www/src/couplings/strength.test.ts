import { expect, it } from "vitest";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./coupling-slider";

it("grows to the right, from the largest variance to the smallest", () => {
  expect([alphaOf(WEAKEST), alphaOf(STRONGEST)].map((alpha) => alpha.toPrecision(6))).toEqual(
    [ALPHA_MAX, ALPHA_MIN].map((alpha) => alpha.toPrecision(6)),
  );
  expect(strengthOf(0.1)).toBeGreaterThan(strengthOf(10));
  expect([1e9, 1, 1e-9].map(placeOf)).toEqual([0, 0.5, 1]);
  for (const alpha of [0.002, 0.46, 10, 900]) expect(alphaOf(strengthOf(alpha))).toBeCloseTo(alpha, 9);
});
