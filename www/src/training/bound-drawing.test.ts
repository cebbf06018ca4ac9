import { expect, it } from "vitest";
import { boundRange } from "./bound-drawing";

it("leaves out the fall of the first iterations", () => {
  const course = [-1e6, -1e5, -1e4, ...Array.from({ length: 100 }, (_, i) => 1000 + i)];
  const [low, high] = boundRange(course);
  expect(low).toBeGreaterThan(900);
  expect(high).toBeGreaterThan(1099);
});

it("draws all of a short course, and accepts an empty one", () => {
  const [low, high] = boundRange([5, 1, Number.NaN, 9]);
  expect(low).toBeLessThan(1);
  expect(high).toBeGreaterThan(9);
  expect(boundRange([])).toEqual([0, 1]);
  const [flat, above] = boundRange([7, 7]);
  expect(above).toBeGreaterThan(flat);
});

it("samples long courses of several runs of different lengths", () => {
  const course = Array.from({ length: 5000 }, (_, i) =>
    i < 100 ? -1e6 + i : 100 * (1 - Math.exp(-i / 500)),
  );
  const short = course.slice(0, 2000);
  const [low, top] = boundRange([...short, ...course]);
  expect(low).toBeGreaterThan(-100);
  expect(top).toBeGreaterThan(100);
  expect(top).toBeLessThan(120);
});
