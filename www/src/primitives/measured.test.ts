import { expect, it } from "vitest";
import { asOnThePage, MEASURED } from "./measured";

it("writes what a program wrote as the page does: minus signs, times, digits in groups", () => {
  expect(asOnThePage("-1.045 (-2.594 to +0.504)")).toBe("−1.045 (−2.594 to +0.504)");
  expect(asOnThePage("alone: DTW MSE x 1000")).toBe("alone: DTW MSE × 1,000");
  expect(asOnThePage("2424")).toBe("2,424");
  expect(asOnThePage("1.886 ± 0.450")).toBe("1.886 ± 0.450");
  expect(asOnThePage("0.0 %, 78.5 %")).toBe("0.0 %, 78.5 %");
  expect(asOnThePage("a re-learned walk-1")).toBe("a re-learned walk-1");
});

it("leaves no sign of a program in the tables of the lesson", () => {
  const cells = Object.values(MEASURED).flatMap(({ head, rows }) => [...head, ...rows.flat()]);
  expect(cells.filter((cell) => /-\d|\bx \d|\d{4}/.test(cell))).toEqual([]);
});
