import { expect, it } from "vitest";
import comparison from "../../../../docs/comparison.md?raw";
import { TO_RHYTHMIC_DMP, WITHOUT_COUPLINGS } from "./worth";

it("has the numbers of the document", () => {
  const written = ([median = 0, low = 0, high = 0]: readonly number[]) =>
    `${median.toFixed(2)} (${low.toFixed(2)} to ${high.toFixed(2)})`;
  const row = comparison.split("\n").find((line) => line.includes("uncoupled : coupled")) ?? "";
  const cells = row.split("|").map((cell) => cell.trim());
  expect(cells[3]).toContain(written(WITHOUT_COUPLINGS.heldOut));
  expect(cells[6]).toContain(written(WITHOUT_COUPLINGS.training));
  const [median, low, high] = TO_RHYTHMIC_DMP;
  const text = comparison.replace(/\s+/g, " ");
  expect(text).toContain(`${median} times (${low} to ${high}) that of the rhythmic DMP`);
});
