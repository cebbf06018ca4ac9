// The columns that a visitor or a recording gives; the model infers the others. No DOM.
import type { SeriesInfo } from "../engine/series-protocol";
import type { TableEntry } from "./tables-store";

/** Who moves a column that the model does not move. */
export type Giver = "recording" | "hand";

/** Frames on each side that a bend of a curve takes along. */
const BEND = 6;

export class GivenColumns {
  readonly #givers = new Map<string, Giver>();
  /** The curves by hand [frames], with the names of their columns. */
  readonly #hands = new Map<string, Float64Array>();

  /** Whether the model moves all columns. */
  get isEmpty(): boolean {
    return this.#givers.size === 0;
  }

  /** Who moves a column; null: the model. */
  giverOf(column: string): Giver | null {
    return this.#givers.get(column) ?? null;
  }

  /** Gives a column; `curve` is where a hand begins. */
  give(column: string, giver: Giver | null, curve: Float64Array): void {
    if (giver) this.#givers.set(column, giver);
    else this.#givers.delete(column);
    if (giver === "hand") this.#hands.set(column, curve);
  }

  clear(): void {
    this.#givers.clear();
  }

  /** Draws a straight line between two points of a curve by hand. */
  draw(column: string, [a, from]: readonly [number, number], [b, to]: readonly [number, number]): void {
    const curve = this.#hands.get(column);
    if (!curve) return;
    const [first, last] = [Math.max(0, Math.min(a, b)), Math.min(curve.length - 1, Math.max(a, b))];
    for (let frame = first; frame <= last; frame++)
      curve[frame] = a === b ? to : from + ((frame - a) / (b - a)) * (to - from);
  }

  /** Bends a curve by hand at a frame, and its neighbours less. */
  bend(column: string, frame: number, by: number): void {
    const curve = this.#hands.get(column);
    for (let k = -BEND; curve && k <= BEND; k++)
      if (frame + k in curve)
        curve[frame + k] = (curve[frame + k] ?? 0) + by * Math.cos((k / BEND) * (Math.PI / 2)) ** 2;
  }

  /** The given numbers [frames x columns], NaN for missing ones; null if there are none. */
  observed(
    { columns }: Pick<SeriesInfo, "columns">,
    frames: number,
    recorded: Recorded,
  ): Float64Array | null {
    const width = columns.length;
    const all = new Float64Array(frames * width).fill(Number.NaN);
    columns.forEach((name, column) => {
      const curve = this.#curveOf(name, recorded);
      for (let frame = 0; frame < Math.min(frames, curve?.length ?? 0); frame++)
        all[frame * width + column] = curve?.[frame] ?? Number.NaN;
    });
    return all.some((value) => !Number.isNaN(value)) ? all : null;
  }

  #curveOf(name: string, recorded: Recorded): ArrayLike<number> | null {
    const giver = this.#givers.get(name);
    if (giver === "hand") return this.#hands.get(name) ?? null;
    const place = giver && recorded ? recorded.info.columns.indexOf(name) : -1;
    if (!recorded || place < 0) return null;
    const width = recorded.info.columns.length;
    return recorded.values.filter((_, i) => i % width === place);
  }
}

type Recorded = Pick<TableEntry, "info" | "values"> | null;
