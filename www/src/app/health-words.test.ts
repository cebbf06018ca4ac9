import { expect, it } from "vitest";
import { MOVES_ON, STANDS_STILL } from "../engine/engine.fake";
import { healthWords } from "./health-words";

const parts = [{ name: "lower" }, { name: "upper" }];

it("says nothing of a motion that goes on, or rests as its recording does", () => {
  expect(healthWords(null, parts, false)).toBe("");
  expect(healthWords(MOVES_ON, parts, true)).toBe("");
  expect(healthWords({ ...STANDS_STILL, state: "rests as recorded" }, parts, false)).toBe("");
});

it("says from when on there is none", () => {
  expect(healthWords(STANDS_STILL, parts, false)).toBe("The model stands still from 2.4 s on.");
  expect(healthWords({ ...STANDS_STILL, from: 0 }, parts, true)).toBe(
    "With these couplings the model stands still from the start.",
  );
  const away = { state: "leaves the training range" as const, from: 3, part: 1, rank: 1 };
  expect(healthWords(away, parts, false)).toMatch(/^From 3.0 s on upper is far from all that the model learned/);
  expect(healthWords({ ...away, state: "not finite", from: null }, parts, false)).toMatch(/breaks down/);
});
