import { expect, it } from "vitest";
import { EQUATION_NAMES, EQUATIONS, SYMBOLS } from "./equations";

const all = [...Object.values(EQUATIONS), ...Object.values(SYMBOLS)];

it("separates words and symbols, although MathML drops blanks at the ends of an element", () => {
  expect(all.filter((math) => /> | </.test(math))).toEqual([]);
  expect(EQUATIONS.bound).toContain("<mtext>poses\u00a0</mtext>");
});

it("puts a space around the name of the logarithm, and no tall brackets around its number", () => {
  const around = all.join("").split("<mi>log</mi>");
  expect(around.length).toBe(4);
  for (const before of around.slice(0, -1)) expect(before).toMatch(/<\/mspace>$/);
  for (const after of around.slice(1)) expect(after).toMatch(/^<mo>\u2061<\/mo><mspace /);
  expect(EQUATIONS.collapsed).not.toContain("<mo>(</mo><mn>2</mn>");
});

it("has a bold letter for the expectation", () => {
  expect(all.filter((math) => math.includes("mathvariant"))).toEqual([]);
  for (const equation of [EQUATIONS.posterior, EQUATIONS.rollout]) expect(equation).toContain("<mi>𝐄</mi>");
});

it("gives each equation a name of its own, so that a screen reader can tell them apart", () => {
  const names = Object.keys(EQUATIONS).map((name) => EQUATION_NAMES[name as keyof typeof EQUATIONS]);
  expect(new Set(names).size).toBe(names.length);
  expect(names.every(Boolean)).toBe(true);
});
