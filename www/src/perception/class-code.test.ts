import { expect, it } from "vitest";
import { answersOf, codeOf, codesOf, MOST_ANSWERS, readCode } from "./class-code";
import type { Side } from "./trial-view";

const HASH = "a3f19c0b";
const sides = (count: number): Side[] =>
  Array.from({ length: count }, (_, i) => (i % 3 === 0 ? "left" : "right"));
const coded = (count: number, seed = 4294967295, simulated = false) => ({
  seed,
  simulated,
  answers: sides(count),
});

it("writes answers as a short code, and reads the same answers", () => {
  for (const count of [1, 7, 8, 9, 36, MOST_ANSWERS])
    for (const seed of [0, 1, 123456789, 4294967295]) {
      const code = codeOf(HASH, coded(count, seed, count === 9));
      expect(readCode(HASH, `${code}`)).toEqual(coded(count, seed, count === 9));
    }
  expect(codeOf(HASH, coded(36))?.replaceAll("-", "").length).toBeLessThanOrEqual(22);
});

it("has no code for no answer, and for more than fit", () => {
  expect([codeOf(HASH, coded(0)), codeOf(HASH, coded(MOST_ANSWERS + 1))]).toEqual([null, null]);
});

it("reads a code in capitals, with spaces, and with letters that look like digits", () => {
  const code = codeOf(HASH, coded(12, 65536)) ?? "";
  expect(code).toMatch(/0/);
  const asWritten = code.toUpperCase().replaceAll("0", "O").replaceAll("1", "l").replaceAll("-", " ");
  expect(readCode(HASH, asWritten)).toEqual(coded(12, 65536));
});

it("notices each single wrong sign, a missing end, and another study", () => {
  const code = codeOf(HASH, coded(24, 987654)) ?? "";
  const signs = code.replaceAll("-", "");
  // The last sign has bits after the end.
  for (let place = 0; place < signs.length - 1; place++) {
    const other = signs[place] === "7" ? "8" : "7";
    const wrong = signs.slice(0, place) + other + signs.slice(place + 1);
    expect(() => readCode(HASH, wrong), wrong).toThrow("expected");
  }
  expect(() => readCode(HASH, signs.slice(0, -2))).toThrow("incomplete");
  expect(() => readCode(HASH, "")).toThrow("incomplete");
  expect(() => readCode(HASH, "abc!")).toThrow("found “!”");
  expect(() => readCode("00001111", code)).toThrow("another study");
});

it("reads a column of codes, each once, and names the line of a wrong one", () => {
  const [first, second] = [codeOf(HASH, coded(5, 1)), codeOf(HASH, coded(5, 2))];
  expect(codesOf(HASH, `${first}\r\n\n  ${second}\n${first}\n`).map(({ seed }) => seed)).toEqual([1, 2]);
  expect(() => codesOf(HASH, `${first}\n${second}x`)).toThrow(/^line 2: expected/);
});

it("takes the answers among all rows, and none when one is missing", () => {
  expect(answersOf([{ page: "consent" }, { kind: "comparison", response: "left" }])).toEqual(["left"]);
  expect(answersOf([{ kind: "comparison", response: null }])).toBeNull();
});
