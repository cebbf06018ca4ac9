// The parts of the columns: a first guess from the names of the columns, and the changes of the visitor.
import { MAX_PARTS } from "../engine/limits";
import type { TablePart } from "../engine/series-protocol";
import { freeName } from "../clips/part-names";

/**
 * Parts by the prefixes of the column names: "arm_x" and "arm.y" belong to "arm". If the prefixes do not give
 * two or more parts, all columns are one part.
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

/** The index of a column's part. */
export const placeOf = (parts: readonly TablePart[], column: string): number =>
  parts.findIndex(({ columns }) => columns.includes(column));

/** Moves a column to another part. The columns of a part are in the order of the table. */
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

/** Adds a part without columns. */
export function added(parts: readonly TablePart[]): TablePart[] {
  return parts.length >= MAX_PARTS ? [...parts] : [...parts, { name: freeName(parts), columns: [] }];
}

/** Removes a part. Its columns move to the previous part, or from the first part to the next. */
export function without(parts: readonly TablePart[], table: readonly string[], gone: number): TablePart[] {
  if (parts.length < 2) return [...parts];
  const heir = gone === 0 ? 1 : gone - 1;
  const orphans = parts[gone]?.columns ?? [];
  const inherited = orphans.reduce<TablePart[]>((now, column) => moved(now, table, column, heir), [...parts]);
  return inherited.filter((_, part) => part !== gone);
}
