import { expect, it } from "vitest";
import { spotlight } from "./spotlight";

it("lights the frames of the largest weights, also with a wide kernel", () => {
  const lit = spotlight(new Float64Array([0, 0.7, 0.8, 0.99, 1, 0.75, 0.72]));
  expect(lit[4]).toBe(1);
  expect(lit[3]).toBeGreaterThan(0.8);
  expect([lit[0], lit[1], lit[6]]).toEqual([0, 0, 0]);
});

it("is dim for small weights, and dark without weights", () => {
  expect(Math.max(...spotlight(new Float64Array([0.001, 0.002, 0.003])))).toBeLessThan(0.02);
  expect([...spotlight(new Float64Array(3))]).toEqual([0, 0, 0]);
});
