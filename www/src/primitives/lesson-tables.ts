// The tables of the experiment, with numbers written as on the rest of the page.
import { grouped } from "../ui/format";
import { primitivesWords } from "../words/primitives";
import stored from "./modularity.json";

export interface Table {
  head: string[];
  rows: string[][];
}

/** "-1234.5 (x 1000)" becomes "−1,234.5 (× 1,000)". A hyphen within a word stays. */
export function pageNumbers(cell: string): string {
  const numbers = /(?<![\w.-])-?\d+(?:\.(\d+))?/g;
  return cell
    .replace(numbers, (number: string, decimals = "") => grouped(Number(number), decimals.length))
    .replace(/\bx (?=\d)/g, "× ");
}

function rewritten({ head, rows }: Table): Table {
  const { cells } = primitivesWords().lesson;
  const written = (cell: string) => pageNumbers(cells[cell] ?? cell);
  return { head: head.map(written), rows: rows.map((row) => row.map(written)) };
}

/** The tables in the language of the page. */
export const lessonTables = () => ({
  modular: rewritten(stored.modular),
  imports: rewritten(stored.imports),
  combination: rewritten(stored.combination),
});
