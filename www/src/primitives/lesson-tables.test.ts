import { expect, it } from "vitest";
import { primitives as german } from "../words/de/primitives";
import { pageNumbers, lessonTables } from "./lesson-tables";

it("writes minus signs, times and grouped digits as the page does", () => {
  expect(pageNumbers("-1.045 (-2.594 to +0.504)")).toBe("−1.045 (−2.594 to +0.504)");
  expect(pageNumbers("alone: DTW MSE x 1000")).toBe("alone: DTW MSE × 1,000");
  expect(pageNumbers("2424")).toBe("2,424");
  expect(pageNumbers("1.886 ± 0.450")).toBe("1.886 ± 0.450");
  expect(pageNumbers("0.0 %, 78.5 %")).toBe("0.0 %, 78.5 %");
  expect(pageNumbers("a re-learned walk-1")).toBe("a re-learned walk-1");
});

it("leaves no hyphen or x of the program in the tables of the lesson", () => {
  const cells = Object.values(lessonTables()).flatMap(({ head, rows }) => [...head, ...rows.flat()]);
  expect(cells.filter((cell) => /-\d|\bx \d|\d{4}/.test(cell))).toEqual([]);
});

it("has German words for all heads, and for the first column of the other tables", () => {
  const { modular, imports, combination } = lessonTables();
  const rows = [...imports.rows, ...combination.rows].map(([first = ""]) => first);
  const written = [...modular.head, ...imports.head, ...combination.head, ...rows];
  const known = Object.keys(german.lesson.cells).map(pageNumbers);
  expect(written.filter((cell) => !known.includes(cell))).toEqual([]);
});
