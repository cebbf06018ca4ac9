import { expect, it } from "vitest";
import { backFrom } from "./next-chapter";

it("counts the seconds until a path stays near the loop", () => {
  expect(backFrom(Float64Array.of(2, 0.05, 0.5, 0.09, 0.01), 0.5)).toBe(2);
  expect(backFrom(Float64Array.of(0.01, 0.02), 0.5)).toBe(0.5);
});

it("says so when a path does not come back", () => {
  expect(backFrom(Float64Array.of(0.01, 3), 0.5)).toBeNull();
  expect(backFrom(Float64Array.of(0.01, Number.NaN), 0.5)).toBeNull();
  expect(backFrom(new Float64Array(0), 0.5)).toBeNull();
});
