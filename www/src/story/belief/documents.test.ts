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

/** The probability that a sum of normal steps, divided by the root of their number, stays within `limit` at each look. */
function stays(limit: number, looks: number): number {
  const step = 0.02;
  const within = (look: number) => {
    const count = Math.floor((limit * Math.sqrt(look)) / step);
    return Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * step);
  };
  const normal = (x: number) => (step * Math.exp(-0.5 * x * x)) / Math.sqrt(2 * Math.PI);
  let [places, masses] = [within(1), within(1).map(normal)];
  for (let look = 2; look <= looks; look++) {
    const next = within(look);
    masses = next.map((y) => places.reduce((sum, x, i) => sum + masses[i]! * normal(y - x), 0));
    places = next;
  }
  return masses.reduce((sum, mass) => sum + mass, 0);
}

it("the limit of Pocock's rule is that of its looks", () => {
  let [low, high] = [1.5, 3];
  for (let halvings = 0; halvings < 8; halvings++) {
    const middle = (low + high) / 2;
    [low, high] = stays(middle, 3) > 0.95 ? [low, middle] : [middle, high];
  }
  const limits = [...comparison.replace(/\s+/g, " ").matchAll(/rule for three looks \(([\d.]+) %/g)];
  expect(limits.map(([, limit]) => Number(limit))).toEqual([2.2, 2.2]);
  expect(Math.abs(100 * (1 - stays(low, 1)) - 2.2)).toBeLessThan(0.1);
});
