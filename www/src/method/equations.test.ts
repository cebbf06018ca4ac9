import { expect, it } from "vitest";
import { EQUATIONS, SYMBOLS } from "./equations";

const all = [...Object.values(EQUATIONS), ...Object.values(SYMBOLS)];

it("keeps words apart from the symbols beside them: MathML drops blanks at the ends of an element", () => {
  expect(all.filter((math) => /> | </.test(math))).toEqual([]);
  expect(EQUATIONS.bound).toContain("<mtext>poses\u00a0</mtext>");
});

it("sets a space around the name of the logarithm, which browsers do not, and no tall brackets around its number", () => {
  const around = all.join("").split("<mi>log</mi>");
  expect(around.length).toBe(4);
  for (const before of around.slice(0, -1)) expect(before).toMatch(/<\/mspace>$/);
  for (const after of around.slice(1)) expect(after).toMatch(/^<mo>\u2061<\/mo><mspace /);
  expect(EQUATIONS.collapsed).not.toContain("<mo>(</mo><mn>2</mn>");
});

it("has the expectation bold by its letter, which is all that browsers show", () => {
  expect(all.filter((math) => math.includes("mathvariant"))).toEqual([]);
  for (const equation of [EQUATIONS.posterior, EQUATIONS.rollout]) expect(equation).toContain("<mi>𝐄</mi>");
});
