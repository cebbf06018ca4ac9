// Tables as files (RFC 4180): full precision, nothing rounded.

export type Field = string | number | null;

export interface Table {
  /** Names of the columns with their units. */
  header: string[];
  rows: Field[][];
}

/** A spreadsheet computes texts that begin with one of these. The library's `series/csv.rs` has the same list. */
export const FORMULA_SIGNS = "=+-@\t\r\n＝＋－＠";

/**
 * A text that a spreadsheet would compute as a formula gets an apostrophe: names come from strangers' files.
 */
export const guarded = (text: string): string =>
  text !== "" && FORMULA_SIGNS.includes(text.charAt(0)) ? `'${text}` : text;

function fieldText(field: Field): string {
  if (field === null) return "";
  if (typeof field === "number") return Number.isFinite(field) ? String(field) : "";
  const text = guarded(field);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function csv({ header, rows }: Table): string {
  return [header, ...rows].map((row) => `${row.map(fieldText).join(",")}\r\n`).join("");
}
