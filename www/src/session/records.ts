// A visit as records that can be kept: clips, trainings, a model from elsewhere, results of a comparison; and
// back again.
import type { KeptClip } from "../clips/clips-store";
import type { ClipSource } from "../engine/protocol";
import type { Run, RunClip } from "../training/runs";

/** What there is to bring back. */
export interface Counts {
  clips: number;
  runs: number;
  models: number;
  results: number;
  /** Of primitives. Absent in what visits of before left. */
  libraries?: number;
}

/** The record that says what the others are. */
export interface About extends Counts {
  /** When it was written, in milliseconds since 1970. */
  at: number;
  /** The page's address, without "#". */
  fragment: string;
  firstBones: boolean;
  /** The runs, by their ids, in their order. */
  order: number[];
  /** The id of the run on the stage; null: another model. */
  chosen: number | null;
  /** Absent in what visits of before left: nobody knows whether it was on a disk. */
  unsaved?: Holdings["unsaved"];
}

/** What a visit holds. */
export interface Holdings {
  fragment: string;
  clips: readonly (KeptClip & { id: number })[];
  firstBones: boolean;
  runs: readonly Run[];
  chosen: Run | null;
  /** The document of a model on the stage that is in no list. */
  model: string | null;
  /** The file of the comparison that is looked at. */
  results: string | null;
  /** Whether these two are on no disk. */
  unsaved: { model: boolean; results: boolean };
  /** The library of primitives that is looked at, unless it is the page's own. */
  library: KeptLibrary | null;
}

/** A library of primitives. */
export interface KeptLibrary {
  text: string;
  title: string;
  /** Whether it was saved nowhere else. */
  unsaved: boolean;
}

/** A file stands in a record of its own, under this name. */
type Source = { sample: string } | { name: string; file: string };
type Stored<Thing extends { source: ClipSource }> = Omit<Thing, "source"> & { source: Source };

export const isWorthKeeping = ({ clips, runs, models, results, libraries = 0 }: Counts) =>
  clips + runs + models + results + libraries > 0;

const list = (words: readonly string[]) =>
  words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;

/** "2 clips and a training". */
export function countsInWords({ clips, runs, models, results, libraries = 0 }: Counts): string {
  const some = (count: number, one: string, more: string) =>
    count === 0 ? [] : [count === 1 ? one : `${count} ${more}`];
  return list([
    ...some(clips, "a clip", "clips"),
    ...some(runs, "a training", "trainings"),
    ...some(models, "a model", "models"),
    ...some(results, "a comparison", "comparisons"),
    ...some(libraries, "a library of primitives", "libraries"),
  ]);
}

/** Writes a visit as records. What has not changed since the last time is left out. */
export class RecordWriter {
  /** What each record was made of. */
  #written = new Map<string, readonly unknown[]>();
  readonly #files = new WeakMap<Blob, string>();
  #lastFile = 0;

  /**
   * The records that differ from those before; undefined: it is no longer there. Null: there is nothing worth
   * keeping, and was not.
   */
  changes(now: Holdings, at: number): Map<string, unknown> | null {
    const made = new Map<string, { of: readonly unknown[]; value(): unknown }>();
    const keep = (name: string, of: readonly unknown[], value: () => unknown) =>
      made.set(name, { of, value });
    const stored = <Thing extends { source: ClipSource }>(thing: Thing): Stored<Thing> => {
      const { source } = thing;
      if (!("file" in source)) return { ...thing, source };
      const file = this.#nameOf(source.file);
      keep(file, [source.file], () => source.file);
      return { ...thing, source: { name: source.name, file } };
    };
    const clips = now.clips.map(stored);
    keep("clips", [JSON.stringify(clips)], () => clips);
    for (const run of now.runs) {
      const kept = { ...run, clips: run.clips.map(stored) };
      keep(`run ${run.id}`, [run.state, run.steps.length, run.model, run.settings], () => kept);
    }
    if (now.model !== null) keep("model", [now.model], () => now.model);
    if (now.results !== null) keep("results", [now.results], () => now.results);
    const { library } = now;
    if (library !== null) keep("library", [library.text, library.unsaved], () => library);
    const counts: Counts = {
      clips: now.clips.filter(({ origin }) => origin === "own").length,
      runs: now.runs.length,
      models: now.model === null ? 0 : 1,
      results: now.results === null ? 0 : 1,
      libraries: library === null ? 0 : 1,
    };
    if (!isWorthKeeping(counts) && this.#written.size === 0) return null;
    const { fragment, firstBones } = now;
    const order = now.runs.map(({ id }) => id);
    const { unsaved } = now;
    const about: About = {
      ...counts,
      at,
      fragment,
      firstBones,
      order,
      chosen: now.chosen?.id ?? null,
      unsaved,
    };
    keep("about", [at], () => about);

    const isSame = (name: string, of: readonly unknown[]) => {
      const before = this.#written.get(name);
      return before?.length === of.length && before.every((part, i) => part === of[i]);
    };
    const changes = new Map<string, unknown>();
    for (const [name, { of, value }] of made) if (!isSame(name, of)) changes.set(name, value());
    for (const name of this.#written.keys()) if (!made.has(name)) changes.set(name, undefined);
    this.#written = new Map([...made].map(([name, { of }]) => [name, of]));
    return changes;
  }

  /** What was to be written was not: the next time all of it is. */
  forget(): void {
    this.#written.clear();
  }

  #nameOf(file: Blob): string {
    const known = this.#files.get(file);
    if (known !== undefined) return known;
    this.#lastFile += 1;
    const name = `file ${this.#lastFile}`;
    this.#files.set(file, name);
    return name;
  }
}

/** A visit from its records. Fails where one of them is missing. */
export function readRecords(records: ReadonlyMap<string, unknown>): { about: About; holdings: Holdings } {
  const get = <Value>(name: string): Value => {
    if (!records.has(name)) throw new Error(`a piece of it is missing (${name})`);
    return records.get(name) as Value;
  };
  const loaded = <Thing extends { source: Source }>(
    thing: Thing,
  ): Omit<Thing, "source"> & { source: ClipSource } => {
    const { source } = thing;
    if (!("file" in source)) return { ...thing, source };
    return { ...thing, source: { name: source.name, file: get<Blob>(source.file) } };
  };
  const about = get<About>("about");
  const runs = about.order.map((id) => {
    const run = get<Omit<Run, "clips"> & { clips: Stored<RunClip>[] }>(`run ${id}`);
    return { ...run, clips: run.clips.map(loaded) };
  });
  const holdings: Holdings = {
    fragment: about.fragment,
    clips: get<Stored<KeptClip & { id: number }>[]>("clips").map(loaded),
    firstBones: about.firstBones,
    runs,
    chosen: runs.find(({ id }) => id === about.chosen) ?? null,
    model: (records.get("model") as string | undefined) ?? null,
    results: (records.get("results") as string | undefined) ?? null,
    unsaved: about.unsaved ?? { model: true, results: true },
    library: (records.get("library") as KeptLibrary | undefined) ?? null,
  };
  return { about, holdings };
}
