import { expect, it } from "vitest";
import { GivenColumns } from "./given-columns";

const info = { columns: ["a", "b"] };
/** A table with its columns in another order, and two rows. */
const recorded = {
  info: { name: "t", sha256: "t", columns: ["b", "c", "a"], rows: 2, frameTime: 0.1, warnings: [] },
  values: Float64Array.from([1, 2, 3, 4, 5, 6]),
};

it("gives recorded columns as long as the recording lasts, and leaves the others missing", () => {
  const given = new GivenColumns();
  expect(given.observed(info, 3, recorded)).toBeNull();
  given.give("a", "recording", new Float64Array());
  expect([...(given.observed(info, 3, recorded) ?? [])]).toEqual([3, NaN, 6, NaN, NaN, NaN]);
  expect(given.observed(info, 3, null)).toBeNull();
  given.give("a", null, new Float64Array());
  expect([given.giverOf("a"), given.observed(info, 3, recorded)]).toEqual([null, null]);
});

it("draws and bends a curve by hand", () => {
  const given = new GivenColumns();
  given.give("b", "hand", new Float64Array(5));
  given.draw("b", [3, 6], [1, 2]);
  const curve = () => [...(given.observed(info, 5, null) ?? [])].filter((_, i) => i % 2 === 1);
  expect(curve()).toEqual([0, 2, 4, 6, 0]);
  given.draw("b", [4, 0], [4, 9]);
  given.draw("b", [4, 9], [8, 9]);
  expect(curve()).toEqual([0, 2, 4, 6, 9]);
  given.bend("b", 0, 10);
  expect(curve().map((value, frame) => value > ([0, 2, 4, 6, 9][frame] ?? 0))).toEqual(Array(5).fill(true));
  expect(curve()[0]).toBe(10);
});
