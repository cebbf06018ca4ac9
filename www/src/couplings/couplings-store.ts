// The couplings of one model: as learned, and as the visitor has set them. Bodies, tables and libraries of
// primitives use this one store.
import type { Couplings, Reading } from "../engine/protocol";
import type { ChangedCouplings } from "../settings/settings";
import { weights } from "./weights";

/** In the order of the choices. */
export const READINGS: readonly Reading[] = ["re-inferred", "as-learned"];

/** What the visitor has chosen. */
export interface ChosenCouplings {
  /** The couplings that differ from the learned ones. */
  alpha: ChangedCouplings;
  reading: Reading;
}

/** Where the choice is stored: for the body in the settings, and so in the address. */
export interface CouplingsPlace {
  readonly values: Readonly<ChosenCouplings>;
  change(change: Partial<ChosenCouplings>): void;
}

/**
 * "set": some couplings were set; "reset": some are as learned again; "all": all couplings changed at once.
 */
export type CouplingsChange = "set" | "reset" | "all" | "reading";

/** Couplings whose logarithms differ by less are the same: a link rounds them to four digits. */
const CLOSE = 0.005;

/** Whether two coupling variances are the same for a visitor. */
export function isClose(a: number, b: number): boolean {
  return Math.abs(Math.log(a / b)) < CLOSE;
}

export class CouplingsStore {
  #learned: Couplings = [];
  readonly #changed: (change: CouplingsChange) => void;
  /** The reading before `takeAll` brought another one. */
  #ownReading: Reading | null = null;

  /** `changed` is called after each change by the visitor. */
  constructor(
    changed: (change: CouplingsChange) => void,
    private readonly place: CouplingsPlace = inMemory(),
  ) {
    this.#changed = changed;
  }

  /** alpha[source][target] as learned; empty for a model without couplings. */
  get learned(): Couplings {
    return this.#learned;
  }

  /** alpha[source][target] now. */
  get alpha(): Couplings {
    return this.#learned.map((row, source) =>
      row.map((alpha, target) => this.#chosen(source, target) ?? alpha),
    );
  }

  get reading(): Reading {
    return this.place.values.reading;
  }

  /** Whether a coupling differs from the learned one. */
  get altered(): boolean {
    return Object.keys(this.place.values.alpha).length > 0;
  }

  /** Whether all couplings are these, as closely as a visitor can tell. */
  isAt(alpha: Couplings): boolean {
    return this.alpha.every((row, i) => row.every((value, j) => isClose(value, alpha[i]?.[j] ?? Number.NaN)));
  }

  learnedAlpha(source: number, target: number): number {
    return this.#learned[source]?.[target] ?? 1;
  }

  alphaOf(source: number, target: number): number {
    return this.#chosen(source, target) ?? this.learnedAlpha(source, target);
  }

  isChanged(source: number, target: number): boolean {
    return this.#chosen(source, target) !== undefined;
  }

  /** The weights of all sources of a part, which sum to 1. */
  weightsInto(target: number): number[] {
    return weights(this.#alphasInto(target));
  }

  weight(source: number, target: number): number {
    return this.weightsInto(target)[source] ?? 0;
  }

  learnedWeight(source: number, target: number): number {
    return weights(this.#learned.map((_, other) => this.learnedAlpha(other, target)))[source] ?? 0;
  }

  /** The coupling between two different parts with the largest weight; null for a model of one part. */
  strongestBetween(): { source: number; target: number } | null {
    const parts = this.#learned.map((_, part) => part);
    const pairs = parts.flatMap((source) =>
      parts.filter((target) => target !== source).map((target) => ({ source, target })),
    );
    const weight = (pair: { source: number; target: number }) => this.weight(pair.source, pair.target);
    return pairs.sort((a, b) => weight(b) - weight(a))[0] ?? null;
  }

  set(source: number, target: number, alpha: number): void {
    if (this.#learned.length === 0) return;
    const changed = this.#without(pair(source, target));
    if (!isClose(alpha, this.learnedAlpha(source, target))) changed[pair(source, target)] = alpha;
    this.place.change({ alpha: changed });
    this.#changed("set");
  }

  /** Sets all couplings at once, and a reading that lasts until `resetAll`. */
  takeAll(alpha: ChangedCouplings, reading = this.reading): void {
    this.#ownReading ??= this.reading;
    this.place.change({ alpha, reading });
    this.#changed("all");
  }

  reset(source: number, target: number): void {
    this.place.change({ alpha: this.#without(pair(source, target)) });
    this.#changed("reset");
  }

  /** Resets all couplings, and the reading that `takeAll` brought. */
  resetAll(): void {
    this.place.change({ alpha: {}, reading: this.#ownReading ?? this.reading });
    this.#ownReading = null;
    this.#changed("all");
  }

  setReading(reading: Reading): void {
    this.#ownReading = null;
    this.place.change({ reading });
    this.#changed("reading");
  }

  /** Takes the couplings of another model, and keeps the changes of the visitor. */
  setLearned(learned: Couplings): void {
    this.#learned = learned;
  }

  /** Takes the couplings of another model, without changes. */
  learn(learned: Couplings): void {
    this.#learned = learned;
    this.place.change({ alpha: {} });
  }

  #chosen(source: number, target: number): number | undefined {
    return this.place.values.alpha[pair(source, target)];
  }

  #alphasInto(target: number): number[] {
    return this.#learned.map((_, source) => this.alphaOf(source, target));
  }

  #without(left: string): ChangedCouplings {
    return Object.fromEntries(Object.entries(this.place.values.alpha).filter(([pair]) => pair !== left));
  }
}

/** The couplings that differ from the learned ones. */
export function changedFrom(learned: Couplings, alpha: Couplings): ChangedCouplings {
  const changed: ChangedCouplings = {};
  for (const [source, row] of alpha.entries())
    for (const [target, value] of row.entries())
      if (!isClose(value, learned[source]?.[target] ?? 1)) changed[pair(source, target)] = value;
  return changed;
}

function inMemory(): CouplingsPlace {
  let values: ChosenCouplings = { alpha: {}, reading: "re-inferred" };
  return {
    get values() {
      return values;
    },
    change(change) {
      values = { ...values, ...change };
    },
  };
}

/** The name of a coupling in the settings. */
function pair(source: number, target: number): string {
  return `${source}.${target}`;
}
