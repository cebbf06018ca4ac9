import { expect, it } from "vitest";
import { words as de } from "./de";
import { words as en } from "./en";
import { EQUATIONS, equationsWith, SYMBOLS } from "./equations";

const all = [
  ...[en, de].flatMap(({ inEquations }) => Object.values(equationsWith(inEquations))),
  ...Object.values(EQUATIONS),
  ...Object.values(SYMBOLS),
];

it("separates words and symbols, although MathML drops blanks at the ends of an element", () => {
  expect(all.filter((math) => /> | </.test(math))).toEqual([]);
  expect(equationsWith(en.inEquations).bound).toContain("<mtext>poses\u00a0</mtext>");
  expect(equationsWith(de.inEquations).bound).toContain("<mtext>Posen\u00a0</mtext>");
});

it("puts a space around the name of the logarithm, and no tall brackets around its number", () => {
  const around = all.join("").split("<mi>log</mi>");
  expect(around.length).toBe(5);
  for (const before of around.slice(0, -1)) expect(before).toMatch(/<\/mspace>$/);
  for (const after of around.slice(1)) expect(after).toMatch(/^<mo>\u2061<\/mo><mspace /);
  expect(EQUATIONS.collapsed).not.toContain("<mo>(</mo><mn>2</mn>");
});

it("has a bold letter for the expectation", () => {
  expect(all.filter((math) => math.includes("mathvariant"))).toEqual([]);
  for (const equation of [EQUATIONS.posterior, EQUATIONS.rollout]) expect(equation).toContain("<mi>𝐄</mi>");
});

it("gives each equation a name of its own, so that a screen reader can tell them apart", () => {
  for (const { equations } of [en, de]) {
    const names = Object.values(equations);
    expect(new Set(names).size).toBe(names.length);
  }
});
