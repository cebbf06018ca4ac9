// The rolled-out and the recorded columns of a model over time.
import type { SeriesInfo } from "../engine/series-protocol";
import type { TableEntry } from "./tables-store";

export interface Curve {
  name: string;
  /** The index of the column's part. */
  part: number;
  /** [frames] */
  rolledOut: number[];
  /** [rows], with the same time step; null if the table is not open. */
  recorded: number[] | null;
}

const column = (values: ArrayLike<number>, width: number, place: number): number[] =>
  Array.from({ length: Math.floor(values.length / width) }, (_, row) => values[row * width + place] ?? 0);

/**
 * The curves, one part after the other; `values` [frames x columns]. The columns of the recording may be in
 * another order.
 */
export function curvesOf(
  { parts, columns }: Pick<SeriesInfo, "parts" | "columns">,
  values: Float64Array,
  recorded: Pick<TableEntry, "info" | "values"> | null,
): Curve[] {
  return parts.flatMap(({ joints: places }, part) =>
    places.map((place) => {
      const name = columns[place] ?? "";
      const found = recorded?.info.columns.indexOf(name) ?? -1;
      return {
        name,
        part,
        rolledOut: column(values, columns.length, place),
        recorded:
          recorded && found >= 0 ? column(recorded.values, recorded.info.columns.length, found) : null,
      };
    }),
  );
}
