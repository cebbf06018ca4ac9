// Tables as files (RFC 4180): full precision, nothing rounded.

export type Field = string | number | null;

export interface Table {
  /** Names of the columns with their units. */
  header: string[];
  rows: Field[][];
}

/** The text with an apostrophe first if a spreadsheet would compute it: names come from strangers' files. */
export const guarded = (text: string): string => (/^[=+@\t\r-]/.test(text) ? `'${text}` : text);

function written(field: Field): string {
  if (field === null) return "";
  if (typeof field === "number") return Number.isFinite(field) ? String(field) : "";
  const text = guarded(field);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function csv({ header, rows }: Table): string {
  return [header, ...rows].map((row) => `${row.map(written).join(",")}\r\n`).join("");
}
