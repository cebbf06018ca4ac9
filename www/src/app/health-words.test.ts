import { expect, it } from "vitest";
import { MOVES_ON, STANDS_STILL } from "../engine/documents.fake";
import { healthWords } from "./caption";

const seen = { seconds: 10, parts: [{ name: "lower" }, { name: "upper" }], altered: false };

it("has no notice for a motion that continues, rests as recorded, or stops after the shown time", () => {
  expect(healthWords(MOVES_ON, seen)).toBe("");
  expect(healthWords({ ...STANDS_STILL, state: "rests-as-recorded", rank: 2 }, seen)).toBe("");
  expect(healthWords({ ...STANDS_STILL, from: 12 }, seen)).toBe("");
});

it("says from when on there is none", () => {
  expect(healthWords(STANDS_STILL, seen)).toBe("The model stands still from 2.4 s on.");
  expect(healthWords(STANDS_STILL, { ...seen, altered: true })).toMatch(
    /^With these couplings the model stands still/,
  );
  const away = { state: "leaves-training-range" as const, from: 3, part: 1, rank: 1, pace: null, parts: [] };
  expect(healthWords(away, seen)).toBe("Outside the training range from 3.0 s on: arms.");
  expect(healthWords({ ...away, state: "not-finite", from: null }, seen)).toMatch(/^The model runs away/);
});

it("says which share of the poses of its clips a motion visits, if it is small", () => {
  const pace = { speed: 1, clipSpeed: 1, times: 1, turnsBack: 0, clipTurnsBack: 0 };
  const parts = [{ visited: 0.22, stillFrom: null, pace }];
  const few = { ...MOVES_ON, state: "visits-few-poses" as const, part: 0, rank: 2, pace, parts };
  expect(healthWords(few, seen)).toBe("The model visits 22 % of its clips’ poses in legs.");
});

it("says that a figure which glides keeps one pose", () => {
  const glides = { ...STANDS_STILL, state: "keeps-one-pose" as const };
  expect(healthWords(glides, seen)).toBe("The model keeps one pose from 2.4 s on.");
});
