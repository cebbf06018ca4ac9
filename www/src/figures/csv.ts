// Tables as files (RFC 4180): full precision, nothing rounded.

export type Field = string | number | null;

export interface Table {
  /** Names of the columns with their units. */
  header: string[];
  rows: Field[][];
}

function written(field: Field): string {
  if (field === null) return "";
  if (typeof field === "number") return Number.isFinite(field) ? String(field) : "";
  // A spreadsheet would compute what begins so, and names come from strangers' files. With an apostrophe
  // before it, it is a text.
  if (/^[=+@\t-]/.test(field)) return written(`'${field}`);
  return /[",\r\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;
}

export function csv({ header, rows }: Table): string {
  return [header, ...rows].map((row) => `${row.map(written).join(",")}\r\n`).join("");
}
