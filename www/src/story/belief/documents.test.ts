// The numbers in sentences of documents are those of their tables.
import { expect, it } from "vitest";
import comparison from "../../../../docs/comparison.md?raw";
import completing from "../../../../docs/completing.md?raw";
import couplings from "../../../../docs/couplings.md?raw";
import { words as german } from "../../comparison/de";
import { words as english } from "../../comparison/en";
import modularity from "../../../../docs/modularity.md?raw";
import uncertainty from "../../../../docs/uncertainty.md?raw";

const tables = import.meta.glob<{ default: string }>("../../../../docs/comparison/*.md", {
  query: "?raw",
  eager: true,
});
const compared = Object.values(tables).map((table) => table.default);
/** An example of a ratio, one of an earlier version of the training, and a quotient of two cells. */
const ELSEWHERE = ["0.43 (0.39 to 0.71)", "0.77 (0.59 to 0.94)", "1.04"];

const ratiosOf = (text: string) => text.replaceAll(",", ".").match(/\d+\.\d\d/g) ?? [];

it("the page has the ratios of the document about the comparison", () => {
  expect(ratiosOf(english.lesson)).toHaveLength(6);
  expect(ratiosOf(german.lesson)).toEqual(ratiosOf(english.lesson));
  for (const [of, ratio] of english.lesson.matchAll(/(\d\.\d\d) times \([^)]*\) that of the \w+/g)) {
    expect(ratio).toBeDefined();
    expect(comparison.replace(/\s+/g, " ")).toContain(of);
  }
});

it("the page has the ratios of passing a bottle", () => {
  const [{ found }, section] = [
    english.trials.bottle,
    comparison.split("### ").find((text) => /^Passing/.test(text)),
  ];
  expect(ratiosOf(found)).toHaveLength(6);
  expect(ratiosOf(german.trials.bottle.found)).toEqual(ratiosOf(found));
  for (const ratio of ratiosOf(found)) expect(section).toContain(ratio);
});

it("has the p values and numbers of persons of the primary claims", () => {
  const text = comparison.replace(/\s+/g, " ");
  const [claims, numbers] = [compared.join(), (list: string) => list.match(/[\d.]+/g) ?? []];
  const ps = [...text.matchAll(/\bp ((?:[\d.]+(?:, | and )?)+) %/g)].flatMap(([, list = ""]) =>
    numbers(list),
  );
  const needed = [...text.matchAll(/ by (\d+)/g)].map(([, count]) => count);
  expect(Math.min(ps.length, 2 * needed.length)).toBeGreaterThan(7);
  expect(ps.filter((p) => !claims.includes(`corrected ${p} %`))).toEqual([]);
  expect(needed.filter((count) => !claims.includes(`spread, ${count} persons`))).toEqual([]);
});

it("documents have the ratios and decimals of their tables", () => {
  for (const document of [comparison, couplings, modularity, completing, uncertainty]) {
    const lines = document.split("\n");
    const rows = lines.filter((line) => /^(\||As learned: )/.test(line));
    const known = [...rows, ...(document === comparison ? compared : [])].join().replaceAll(" times (", " (");
    const text = lines.filter((line) => !rows.includes(line)).join(" ");
    const ratios = text.matchAll(/(-?\d+\.\d\d)\D{1,40}?(-?\d+\.\d\d) to (-?\d+\.\d\d)/g);
    const written = [...ratios].map(([, middle, low, high]) => `${middle} (${low} to ${high})`);
    const decimals = (words: string) => words.match(/(?<![\d.])\d+\.\d{2,}/g) ?? [];
    const cells = new Set([...ELSEWHERE, ...decimals(known)]);
    const missing = written.filter((ratio) => !known.includes(ratio) && !cells.has(ratio));
    expect(decimals(text).length).toBeGreaterThan(10);
    expect([...missing, ...decimals(text).filter((decimal) => !cells.has(decimal))]).toEqual([]);
  }
});
