// The map of tempo and coupling: the locking of one part to another, for each tempo and each strength of the
// coupling.
import { isClose } from "../couplings/couplings-store";
import type { Couplings } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { isSame } from "./combinations";
import type { LibraryStore } from "./library-store";

/** Tempos of the target. */
export const TEMPOS: readonly number[] = Array.from({ length: 13 }, (_, i) => (70 + 5 * i) / 100);
/** Factors of the coupling: its variance is divided by them. */
export const STRENGTHS: readonly number[] = Array.from({ length: 11 }, (_, i) => 2 ** (i - 6));

const largestSpread = (lists: readonly (readonly number[])[]) =>
  Math.max(...lists.map((values) => Math.max(...values) - Math.min(...values)));

/** A map, complete or not. */
export interface LockingMap {
  /** The document of the library. */
  library: string;
  uses: readonly number[];
  source: number;
  target: number;
  /** The couplings at strength 1. */
  alpha: Couplings;
  /** For each tempo the locking at each strength, 0 to 1; null before it is computed. */
  rows: (Float64Array | null)[];
}

export class LockingStore extends Store {
  readonly #whole: WholeWorkers;
  readonly #library: LibraryStore;
  #source = 0;
  #target = 1;
  #map: LockingMap | null = null;
  #busy = false;
  #problem = "";
  #stop = new AbortController();

  constructor(whole: WholeWorkers, library: LibraryStore) {
    super();
    this.#whole = whole;
    this.#library = library;
    library.on(() => {
      // The map belongs to another library, to another combination or to other couplings.
      if (this.#map && !this.#isUpToDate(this.#map)) this.#forget();
    });
  }

  get source(): number {
    return this.#source;
  }

  get target(): number {
    return this.#target;
  }

  get map(): LockingMap | null {
    return this.#map;
  }

  get busy(): boolean {
    return this.#busy;
  }

  /** The reason why the map failed; else empty. */
  get problem(): string {
    return this.#problem;
  }

  /** The computed share of the map. */
  get fraction(): number {
    const rows = this.#map?.rows ?? [];
    return rows.filter((row) => row !== null).length / Math.max(1, rows.length);
  }

  /**
   * The largest differences of the locking between two tempos at the same strength, and between two strengths
   * at the same tempo; null before the map is complete.
   */
  get effects(): { tempo: number; strength: number } | null {
    const rows = (this.#map?.rows ?? []).flatMap((row) => (row ? [[...row]] : []));
    if (rows.length < TEMPOS.length) return null;
    const columns = STRENGTHS.map((_, l) => rows.map((row) => row[l] ?? 0));
    return { tempo: largestSpread(columns), strength: largestSpread(rows) };
  }

  /** Chooses the part that leads and the part that follows. */
  choose(source: number, target: number): void {
    [this.#source, this.#target] = [source, target];
    this.#forget();
  }

  /** Computes the map on all workers, one tempo in each job. */
  async make(): Promise<void> {
    const { current, uses } = this.#library;
    if (!current || this.#busy) return;
    const [source, target] = [this.#source, this.#target];
    const stop = new AbortController();
    this.#stop = stop;
    this.#busy = true;
    this.#problem = "";
    this.changed();
    try {
      const { alpha } = this.#library.couplings;
      const library = current.text;
      const map: LockingMap = { library, uses, source, target, alpha, rows: TEMPOS.map(() => null) };
      this.#map = map;
      const { pool } = this.#whole;
      const job = { library, uses: [...uses], source, target, alpha, strengths: [...STRENGTHS] };
      const row = async (tempo: number, index: number) => {
        map.rows[index] = await pool.run((worker) => worker.lockingRow({ ...job, tempo }), stop.signal);
        this.changedSoon();
      };
      await Promise.all(TEMPOS.map(row));
    } catch (problem) {
      if (!stop.signal.aborted) {
        stop.abort();
        this.#map = null;
        this.#problem = messageOf(problem);
      }
    }
    if (this.#stop !== stop) return;
    this.#busy = false;
    this.changed();
  }

  /** Cancels the map, and keeps its computed rows. */
  cancel(): void {
    this.#stop.abort();
  }

  /** Gives the large figure the tempo and the coupling of a point. */
  take(tempo: number, strength: number): void {
    const map = this.#map;
    if (!map) return;
    const { source, target, alpha } = map;
    this.#library.setTempo(source, 1);
    this.#library.setTempo(target, tempo);
    this.#library.takeCouplings(
      alpha.map((row, i) => row.map((value, j) => (i === source && j === target ? value / strength : value))),
    );
  }

  /** The point of the large figure in the map; null if it has none. */
  get taken(): { tempo: number; strength: number } | null {
    const map = this.#map;
    if (!map) return null;
    const { source, target, alpha } = map;
    const tempo = TEMPOS.find((tempo) => tempo === this.#library.tempos[target]);
    const now = this.#library.couplings.alphaOf(source, target);
    const strength = STRENGTHS.find((strength) => isClose((alpha[source]?.[target] ?? 0) / strength, now));
    return tempo === undefined || strength === undefined ? null : { tempo, strength };
  }

  /** Whether only the tempo and the coupling that the map varies may have changed. */
  #isUpToDate({ library, uses, source, target, alpha }: LockingMap): boolean {
    const { current, couplings } = this.#library;
    const varied = couplings.alphaOf(source, target);
    return (
      current?.text === library &&
      isSame(uses, this.#library.uses) &&
      couplings.isAt(
        alpha.map((row, i) => row.map((value, j) => (i === source && j === target ? varied : value))),
      )
    );
  }

  #forget(): void {
    this.#stop.abort();
    this.#map = null;
    this.#busy = false;
    this.#problem = "";
    this.changed();
  }
}
