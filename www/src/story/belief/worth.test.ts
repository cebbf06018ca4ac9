import { expect, it } from "vitest";
import comparison from "../../../../docs/comparison.md?raw";
import together from "../../../../docs/comparison/recorded-trials-together.md?raw";
import completing from "../../../../docs/completing.md?raw";
import modularity from "../../../../docs/modularity.md?raw";
import uncertainty from "../../../../docs/uncertainty.md?raw";
import { belief as german } from "../../words/de/belief";
import { belief as english, type Ratio } from "../../words/en/belief";
import { TO_RHYTHMIC_DMP, WITHOUT_COUPLINGS } from "./worth";

const { training, heldOut } = WITHOUT_COUPLINGS;
const fixed = (ratio: Ratio) => ratio.map((value) => value.toFixed(2));

it("has the numbers of the tables", () => {
  const written = (ratio: Ratio) => {
    const [median, low, high] = fixed(ratio);
    return `${median} (${low} to ${high})`;
  };
  const row =
    comparison.split("\n").find((line) => line.startsWith("| all folders | vCGPDM, uncoupled")) ?? "";
  const cells = row.split("|").map((cell) => cell.trim());
  expect(cells[3]).toContain(written(heldOut));
  expect(cells[6]).toContain(written(training));

  const [median, low, high] = fixed(TO_RHYTHMIC_DMP);
  const best = together.split("\n").find((line) => line.includes("the 2-part vCGPDM performs best")) ?? "";
  expect(best).toContain(`${median} times (${low} to ${high}) DMP (rhythmic)`);
});

it("calls a ratio undecided where its interval contains 1, and no other", () => {
  const isUndecided = ([, low, high]: Ratio) => low <= 1 && high >= 1;
  expect([training, heldOut, TO_RHYTHMIC_DMP].map(isUndecided)).toEqual([false, false, true]);
  expect(english.closing(training, heldOut, TO_RHYTHMIC_DMP)).toMatch(
    /1\.99 times \(1\.31 to 3\.04\) .*1\.82 times \(1\.19 to 2\.77\) .*six persons\..*1\.07 times .*: undecided\./,
  );
  expect(german.closing(training, heldOut, TO_RHYTHMIC_DMP)).toMatch(
    /1,99-mal .*1,82-mal .*sechs Personen\..*1,07-mal .*: unentschieden\./,
  );
});

const tables = import.meta.glob<{ default: string }>("../../../../docs/comparison/*.md", {
  query: "?raw",
  eager: true,
});
const compared = Object.values(tables).map((table) => table.default);
/** An example of a ratio, one of an earlier version of the training, and a quotient of two cells. */
const ELSEWHERE = ["0.43 (0.39 to 0.71)", "0.77 (0.59 to 0.94)", "1.04"];

it("documents have the ratios and decimals of their tables", () => {
  for (const document of [comparison, modularity, completing, uncertainty]) {
    const lines = document.split("\n");
    const rows = lines.filter((line) => line.startsWith("|"));
    const known = [...rows, ...(document === comparison ? compared : [])].join().replaceAll(" times (", " (");
    const text = lines.filter((line) => !line.startsWith("|")).join(" ");
    const ratios = text.matchAll(/(-?\d+\.\d\d)\D{1,40}?(-?\d+\.\d\d) to (-?\d+\.\d\d)/g);
    const written = [...ratios].map(([, middle, low, high]) => `${middle} (${low} to ${high})`);
    const decimals = (words: string) => words.match(/(?<![\d.])\d+\.\d{2,}/g) ?? [];
    const cells = new Set([...ELSEWHERE, ...decimals(known)]);
    const missing = written.filter((ratio) => !known.includes(ratio) && !cells.has(ratio));
    expect(decimals(text).length).toBeGreaterThan(10);
    expect([...missing, ...decimals(text).filter((decimal) => !cells.has(decimal))]).toEqual([]);
  }
});
