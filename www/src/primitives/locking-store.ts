// The map of tempo and coupling: how firmly one part is locked to another, for each tempo of the one and each
// strength of the coupling.
import type { Couplings } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { isSame } from "./combinations";
import type { LibraryStore } from "./library-store";

/** Of the target, from slow to fast. */
export const TEMPOS: readonly number[] = Array.from({ length: 13 }, (_, i) => (70 + 5 * i) / 100);
/** What the coupling is multiplied by: its variance is divided by it. */
export const STRENGTHS: readonly number[] = Array.from({ length: 11 }, (_, i) => 2 ** (i - 6));

/** A map, as far as it is made, and what it is of. */
export interface LockingMap {
  uses: readonly number[];
  source: number;
  target: number;
  /** The couplings that the strengths multiply one of. */
  alpha: Couplings;
  /** Of each tempo, 0 to 1 at each strength; null: not there yet. */
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
      // Another combination has another map.
      if (this.#map && !this.#isOf(this.#map)) this.#forget();
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

  /** Why there is no map; empty where there is one, or none was asked for. */
  get problem(): string {
    return this.#problem;
  }

  /** The share of the map that is made. */
  get fraction(): number {
    const rows = this.#map?.rows ?? [];
    return rows.filter((row) => row !== null).length / Math.max(1, rows.length);
  }

  /** Which part leads, and which follows. */
  choose(source: number, target: number): void {
    [this.#source, this.#target] = [source, target];
    this.#forget();
  }

  /** Makes the map, a tempo at a time, on as many workers as there are. */
  async make(): Promise<void> {
    const { known, uses } = this.#library;
    if (!known || this.#busy) return;
    const [source, target] = [this.#source, this.#target];
    const stop = new AbortController();
    this.#stop = stop;
    this.#busy = true;
    this.#problem = "";
    this.changed();
    try {
      const alpha = await this.#library.nearestTo(uses);
      const map: LockingMap = { uses, source, target, alpha, rows: TEMPOS.map(() => null) };
      this.#map = map;
      const { pool } = this.#whole;
      const job = { library: known.text, uses: [...uses], source, target, strengths: [...STRENGTHS] };
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

  /** What is made stays. */
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

  /** The point that the large figure is at; null: none. */
  get taken(): { tempo: number; strength: number } | null {
    const map = this.#map;
    if (!map) return null;
    const { source, target, alpha } = map;
    const tempo = TEMPOS.find((tempo) => tempo === this.#library.tempos[target]);
    const now = this.#library.couplings.alphaOf(source, target);
    const strength = STRENGTHS.find((strength) => (alpha[source]?.[target] ?? 0) / strength === now);
    return tempo === undefined || strength === undefined ? null : { tempo, strength };
  }

  #isOf({ uses }: LockingMap): boolean {
    return isSame(uses, this.#library.uses);
  }

  #forget(): void {
    this.#stop.abort();
    this.#map = null;
    this.#busy = false;
    this.#problem = "";
    this.changed();
  }
}
