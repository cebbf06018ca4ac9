import { expect, it } from "vitest";
import { randomNumbers } from "./random-numbers";

it("gives the same numbers for the same seed, and others for another", () => {
  const take = (seed: number) => Array.from({ length: 5 }, randomNumbers(seed));
  expect(take(1)).toEqual(take(1));
  expect(take(1)).not.toEqual(take(2));
});

it("spreads the numbers evenly from 0 to 1, also the first ones of small seeds", () => {
  const next = randomNumbers(1);
  const tenths = new Array<number>(10).fill(0);
  for (let i = 0; i < 10_000; i++) tenths[Math.floor(10 * next())]! += 1;
  for (const count of tenths) expect(Math.abs(count - 1000)).toBeLessThan(120);
  const low = Array.from({ length: 1000 }, (_, seed) => randomNumbers(seed + 1)()).filter(
    (first) => first < 0.5,
  );
  expect(Math.abs(low.length - 500)).toBeLessThan(60);
});
