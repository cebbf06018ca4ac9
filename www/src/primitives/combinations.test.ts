import { expect, it } from "vitest";
import type { LibraryInfo } from "../engine/library-protocol";
import {
  combinationsOf,
  countOf,
  exampleOf,
  firstOf,
  primitivesOf,
  recordedAs,
  titleOf,
} from "./combinations";

const primitive = (name: string, part: number) => ({ name, part });
const movement = (name: string, uses: number[], learned = true) => ({ name, uses, learned });
const info = {
  parts: [{ name: "legs" }, { name: "arms" }],
  primitives: [primitive("walk", 0), primitive("walk", 1), primitive("wave", 1), primitive("run", 0)],
  movements: [movement("walk", [0, 1]), movement("tried", [3, 2], false)],
} as unknown as LibraryInfo;

it("makes all combinations of one primitive of each part", () => {
  expect(primitivesOf(info, 1)).toEqual([1, 2]);
  const all = combinationsOf(info, 9);
  expect(all).toEqual([
    [0, 1],
    [0, 2],
    [3, 1],
    [3, 2],
  ]);
  expect(countOf(info)).toBe(4);
  expect(combinationsOf(info, 3)).toHaveLength(3);
  expect(titleOf(info, [3, 2])).toBe("legs: run, arms: wave");
});

it("finds recorded combinations, and begins with one that was not recorded", () => {
  expect(recordedAs(info, [0, 1])).toBe("walk");
  expect(recordedAs(info, [3, 2])).toBeNull();
  expect(firstOf(info, combinationsOf(info, 9))).toEqual([0, 2]);
  expect(firstOf(info, [[0, 1]])).toEqual([0, 1]);
});

it("shows a primitive in a recorded movement, else in its first combination", () => {
  expect(exampleOf(info, 1)).toEqual([0, 1]);
  expect(exampleOf(info, 2)).toEqual([0, 2]);
});
