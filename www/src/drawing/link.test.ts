import { expect, it } from "vitest";
import { circle, drawnBy, eight } from "./example";
import { drawingOf, HEIGHT, WIDTH } from "./hand";
import { drawingIn, textOf } from "./link";

const drawing = drawingOf([[drawnBy(eight)], [drawnBy(circle)]]);

it("brings a drawing back, within a thousandth of the pad where it was smoothed once more", () => {
  const text = textOf(drawing?.rows ?? [], [0, 1]);
  expect(text).toMatch(/^01\.[\w-]+$/);
  expect(text.length).toBeLessThan(1000);
  const found = drawingIn(text);
  expect(found?.pads).toEqual([0, 1]);
  const inner = (rows?: number[][]) => rows?.slice(4, -4) ?? [];
  inner(found?.drawing.rows).forEach((row, i) =>
    row.forEach((value, axis) => {
      const before = inner(drawing?.rows)[i]?.[axis] ?? Number.NaN;
      expect(Math.abs(value - before)).toBeLessThan(0.015 * (axis % 2 === 0 ? WIDTH : HEIGHT));
    }),
  );
});

it("finds no drawing in a damaged link", () => {
  for (const text of ["", "0.", "2.AAAA", "0.AAA", "01.AAAA", "0.AA!A", "0.AAAABBBB"])
    expect(drawingIn(text), text).toBe(null);
});
