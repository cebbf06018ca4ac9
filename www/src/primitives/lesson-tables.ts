// The tables of the experiment, with numbers written as on the rest of the page.
import { grouped } from "../ui/format";
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

const rewritten = ({ head, rows }: Table): Table => ({
  head: head.map(pageNumbers),
  rows: rows.map((row) => row.map(pageNumbers)),
});

export const LESSON_TABLES = { modular: rewritten(stored.modular), imports: rewritten(stored.imports) };
