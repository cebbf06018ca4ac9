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

const files = import.meta.glob<string>("../../../../docs/comparison/*.md", {
  query: "?raw",
  import: "default",
  eager: true,
});
const compared = Object.values(files).join("\n");

/** The tables of a document, and its sentences. */
function divided(document: string): { tables: string; sentences: string } {
  const isRow = (line: string) => line.startsWith("|");
  const lines = document.split("\n");
  const sentences = lines.filter((line) => !isRow(line)).join(" ");
  return { tables: lines.filter(isRow).join("\n"), sentences: sentences.replace(/\s+/g, " ") };
}

it("the documents have no other ratios than their tables", () => {
  // An example of how a ratio is written, and one of an earlier version of the training.
  const elsewhere = ["0.43 (0.39 to 0.71)", "0.77 (0.59 to 0.94)"];
  const ratio = /(-?\d+\.\d\d)\D{1,48}?(-?\d+\.\d\d) to (-?\d+\.\d\d)/g;
  for (const document of [comparison, modularity]) {
    const { tables, sentences } = divided(document);
    const known = `${compared}\n${tables}`.replaceAll(" times (", " (");
    const ratios = [...sentences.matchAll(ratio)].map(
      ([, middle, low, high]) => `${middle} (${low} to ${high})`,
    );
    expect(ratios.length).toBeGreaterThan(5);
    expect(ratios.filter((text) => !known.includes(text) && !elsewhere.includes(text))).toEqual([]);
  }
});

it("the documents have no other decimals than the cells of their tables", () => {
  const decimals = (text: string) => text.match(/(?<![\d.])\d+\.\d{2,}/g) ?? [];
  for (const [document, more] of [
    [comparison, compared],
    [completing, ""],
    [uncertainty, ""],
  ] as const) {
    const { tables, sentences } = divided(document);
    const cells = new Set(decimals(tables + more));
    expect(decimals(sentences).length).toBeGreaterThan(5);
    expect(decimals(sentences).filter((number) => !cells.has(number))).toEqual([]);
  }
});
