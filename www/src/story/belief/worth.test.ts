import { expect, it } from "vitest";
import comparison from "../../../../docs/comparison.md?raw";
import together from "../../../../docs/comparison/recorded-trials-together.md?raw";
import { belief as german } from "../../words/de/belief";
import { belief as english, type Ratio } from "../../words/en/belief";
import { TO_RHYTHMIC_DMP, WITHOUT_COUPLINGS } from "./belief-chapter";

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
