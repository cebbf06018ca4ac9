// Which columns are which part's: a first guess by their names, and what the visitor changes of it. No
// rendering.
import { MAX_PARTS } from "../engine/limits";
import type { TablePart } from "../engine/series-protocol";
import { freeName } from "../ui/part-names";

/**
 * Parts by how the names of columns begin, "arm_x" and "arm.y" being of "arm"; where that tells nothing, all
 * columns are one part.
 */
export function partsByName(columns: readonly string[]): TablePart[] {
  const groups = new Map<string, string[]>();
  for (const column of columns) {
    const [, name = ""] = /^(.+?)[ _.:-]./.exec(column) ?? [];
    groups.set(name, [...(groups.get(name) ?? []), column]);
  }
  const told = !groups.has("") && groups.size > 1 && groups.size <= MAX_PARTS;
  if (!told) return [{ name: "whole", columns: [...columns] }];
  return [...groups].map(([name, own]) => ({ name, columns: own }));
}

/** The place of a column's part. */
export const placeOf = (parts: readonly TablePart[], column: string): number =>
  parts.findIndex(({ columns }) => columns.includes(column));

/** Puts a column into another part; the columns of a part stand in the order of the table. */
export function moved(
  parts: readonly TablePart[],
  table: readonly string[],
  column: string,
  to: number,
): TablePart[] {
  return parts.map(({ name, columns }, part) => ({
    name,
    columns: table.filter((one) => (one === column ? part === to : columns.includes(one))),
  }));
}

/** One more part, without columns. */
export function added(parts: readonly TablePart[]): TablePart[] {
  return parts.length >= MAX_PARTS ? [...parts] : [...parts, { name: freeName(parts), columns: [] }];
}

/** Without one part: its columns go to the one before it, or, of the first, to the next. */
export function without(parts: readonly TablePart[], table: readonly string[], gone: number): TablePart[] {
  if (parts.length < 2) return [...parts];
  const heir = gone === 0 ? 1 : gone - 1;
  const orphans = parts[gone]?.columns ?? [];
  const inherited = orphans.reduce<TablePart[]>((now, column) => moved(now, table, column, heir), [...parts]);
  return inherited.filter((_, part) => part !== gone);
}
