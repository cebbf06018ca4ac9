// A visit as records in the browser's database: clips, trainings, a model from elsewhere, results of a
// comparison, a library of primitives.
import type { StoredClip } from "../clips/clips-store";
import type { ClipSource, UpAxis } from "../engine/protocol";
import type { Run } from "../training/runs";
import { sessionWords } from "../words/sections";

/** How many things of each kind a visit holds. */
export interface Counts {
  clips: number;
  runs: number;
  models: number;
  results: number;
  libraries: number;
}

/** The record about the others. */
interface About extends Counts {
  /** When it was written, in milliseconds since 1970. */
  at: number;
  /** The page's address, without "#". */
  fragment: string;
  firstBones: boolean;
  /** The ids of the runs, in their order. */
  order: number[];
  /** The id of the run on the stage; null: another model. */
  chosen: number | null;
  unsaved: Holdings["unsaved"];
}

/** What a visit holds. */
export interface Holdings {
  fragment: string;
  clips: readonly (StoredClip & { id: number })[];
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
  library: StoredLibrary | null;
}

/** A library of primitives. */
export interface StoredLibrary {
  text: string;
  title: string;
  /** Whether it was saved nowhere else. */
  unsaved: boolean;
}

/** A clip whose file has a record of its own, with this name. */
type StoredSource = { sample: string } | { name: string; file: string; up?: UpAxis; fps?: number };
type Stored<Clip extends { source: ClipSource }> = Omit<Clip, "source"> & { source: StoredSource };

/** The clips that come with the page are not worth a record. */
export const countsOf = ({ clips, runs, model, results, library }: Holdings): Counts => ({
  clips: clips.filter(({ origin }) => origin === "own").length,
  runs: runs.length,
  models: model === null ? 0 : 1,
  results: results === null ? 0 : 1,
  libraries: library === null ? 0 : 1,
});

/** The counts of several visits together. */
export const sumOf = (all: readonly Counts[]): Counts => ({
  clips: all.reduce((sum, { clips }) => sum + clips, 0),
  runs: all.reduce((sum, { runs }) => sum + runs, 0),
  models: all.reduce((sum, { models }) => sum + models, 0),
  results: all.reduce((sum, { results }) => sum + results, 0),
  libraries: all.reduce((sum, { libraries }) => sum + libraries, 0),
});

/** "2 clips and a training"; empty when the counts are 0. */
export function contentsText(counts: Counts): string {
  const words = sessionWords();
  const kinds = ["clips", "runs", "models", "results", "libraries"] as const;
  return words.listed(kinds.flatMap((kind) => (counts[kind] === 0 ? [] : [words[kind](counts[kind])])));
}

/** Writes a visit as records. What has not changed since the last time is left out. */
export class RecordWriter {
  /** For each record in the database the values that it was made from. */
  #written: ReadonlyMap<string, readonly unknown[]> = new Map();
  /** The same once the last changes are written. */
  #next = this.#written;
  readonly #files = new WeakMap<Blob, string>();
  #lastFile = 0;

  /**
   * The records that have changed; undefined: the record is to be removed. Null: nothing is worth a record,
   * and nothing was.
   */
  changes(holdings: Holdings, at: number): Map<string, unknown> | null {
    const made = new Map<string, { sources: readonly unknown[]; value(): unknown }>();
    const add = (name: string, sources: readonly unknown[], value: () => unknown) =>
      made.set(name, { sources, value });
    const stored = <Clip extends { source: ClipSource }>(clip: Clip): Stored<Clip> => {
      const { source } = clip;
      if (!("file" in source)) return { ...clip, source };
      const file = this.#nameOf(source.file);
      add(file, [source.file], () => source.file);
      return { ...clip, source: { ...source, file } };
    };
    const { fragment, firstBones, runs, chosen, model, results, unsaved, library } = holdings;
    const clips = holdings.clips.map(stored);
    add("clips", [JSON.stringify(clips)], () => clips);
    for (const run of runs) {
      const value = { ...run, clips: run.clips.map(stored) };
      add(`run ${run.id}`, [run.state, run.steps.length, run.model, run.settings], () => value);
    }
    if (model !== null) add("model", [model], () => model);
    if (results !== null) add("results", [results], () => results);
    if (library !== null) add("library", [library.text, library.unsaved], () => library);
    if (contentsText(countsOf(holdings)) === "" && this.#written.size === 0) return null;
    const about: About = {
      ...countsOf(holdings),
      at,
      fragment,
      firstBones,
      order: runs.map(({ id }) => id),
      chosen: chosen?.id ?? null,
      unsaved,
    };
    add("about", [at], () => about);

    const isSame = (name: string, sources: readonly unknown[]) => {
      const before = this.#written.get(name);
      return before?.length === sources.length && before.every((source, i) => source === sources[i]);
    };
    const changes = new Map<string, unknown>();
    for (const [name, { sources, value }] of made) if (!isSame(name, sources)) changes.set(name, value());
    for (const name of this.#written.keys()) if (!made.has(name)) changes.set(name, undefined);
    this.#next = new Map([...made].map(([name, { sources }]) => [name, sources]));
    return changes;
  }

  /** The last changes are in the database. */
  wereWritten(): void {
    this.#written = this.#next;
  }

  #nameOf(file: Blob): string {
    const name = this.#files.get(file) ?? `file ${++this.#lastFile}`;
    this.#files.set(file, name);
    return name;
  }
}
