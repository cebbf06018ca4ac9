// A comparison of this visit: its results, the progress of its trainings, and the predicted motions.
import type { AddedResult, Evaluated, Job, ResultsView } from "../engine/whole-protocol";
import type { Body } from "../scene/columns";
import type { FirstMotion } from "../stage/first-motion.js";
import { download } from "../ui/download";
import type { Work } from "../unsaved/unsaved";
import type { JobProgress } from "./jobs";
import type { ComparisonRequest } from "./comparison-request";
import { compareWords } from "./view-words";

/** The most stored motions, of some hundred kilobytes each. */
const MOST_MOTIONS = 400;

/** World positions of a motion [frames x nodes x 3]. */
export interface Positions {
  positions: Float32Array;
  /** Seconds between frames. */
  frameTime: number;
}

/** A motion that a model predicts. */
export interface PredictedMotion extends Positions {
  /** The document of the model, which a browser can move from memory to disk; null: it was not kept. */
  model: Blob | null;
}

export interface ComparisonEntry {
  /** Null: the results are from a file. */
  readonly request: ComparisonRequest | null;
  /** The body of the motions; null: there are none. */
  readonly body: Body | null;
  /** Whether the results come with the page; those of the visitor replace them. */
  readonly given: boolean;
  /** The names of the trials. */
  readonly titles: readonly string[];
  results: ResultsView;
  /** The text of the results on the visitor's disk; empty: they are on none. */
  onDisk: string;
  /** The jobs of the last press of Compare. */
  jobs: readonly JobProgress[];
  /** The predictions of models trained on all other trials, by the job's id. */
  readonly predictions: Map<string, PredictedMotion>;
  /** The motions of the trials held out, by the trial. */
  readonly actual: Map<number, Positions>;
}

/** A comparison for readers. */
export type ReadonlyEntry = Readonly<Omit<ComparisonEntry, "predictions" | "actual">> & {
  readonly predictions: ReadonlyMap<string, PredictedMotion>;
  readonly actual: ReadonlyMap<number, Positions>;
};

/** Without a request the results are from a file. */
export function newEntry(
  request: ComparisonRequest | null,
  results: ResultsView,
  onDisk = "",
): ComparisonEntry {
  const titles = request?.titles ?? results.setting.trials.map(({ name }) => name);
  return {
    request,
    body: request?.body ?? null,
    given: false,
    titles,
    results,
    onDisk,
    jobs: [],
    predictions: new Map(),
    actual: new Map(),
  };
}

/** The entry of the results that come with the page. `motions`: those of a trial, and of models that predict it. */
export function givenEntry(results: ResultsView, motions: FirstMotion | null): ComparisonEntry {
  const entry = { ...newEntry(null, results, results.text), given: true };
  if (!motions) return entry;
  const { figure, joints, parts, positions, frameTime, shown = [] } = motions;
  const length = positions.length / (1 + shown.length);
  const piece = (place: number) => positions.slice(place * length, (place + 1) * length);
  shown.forEach((id, i) => {
    const heldOut = results.finished.find((finished) => finished.id === id)?.job.heldOut;
    if (heldOut === undefined) return;
    entry.predictions.set(id, { positions: piece(1 + i), frameTime, model: null });
    entry.actual.set(heldOut, { positions: piece(0), frameTime });
  });
  return { ...entry, body: { figure, joints, parts } };
}

/** The results with one more. */
export function withResult(results: ResultsView, added: AddedResult): ResultsView {
  const { finished: result, place, text, isWhole, comparison } = added;
  const finished = results.finished.filter(({ id }) => id !== result.id);
  // A file ends with the list of results.
  const comma = results.finished.length > 0 ? "," : "";
  const file = isWhole ? text : `${results.text.slice(0, -"]}".length)}${comma}${text}]}`;
  finished.splice(place, 0, result);
  return { ...results, text: file, finished, comparison };
}

/** Saves the results to the visitor's disk. */
export function saveResults(entry: ComparisonEntry): void {
  const { text } = entry.results;
  download("comparison.results.json", new Blob([text], { type: "application/json" }));
  entry.onDisk = text;
}

/** The results as unsaved work; null: they are on a disk. */
export function workOf(entry: ComparisonEntry | null): Work | null {
  if (!entry || entry.results.finished.length === 0 || entry.results.text === entry.onDisk) return null;
  const { length } = entry.results.finished;
  return {
    what: compareWords().work(length),
    save: () => saveResults(entry),
  };
}

/** Stores the motions of a job, if its model was trained on all other trials. */
export function keepMotions(
  { results, predictions, actual }: ComparisonEntry,
  id: string,
  job: Job,
  evaluated: Evaluated,
): void {
  if (job.trainingTrials !== results.setting.trials.length - 1) return;
  const { frameTime } = evaluated;
  const model = new Blob([evaluated.model], { type: "application/json" });
  predictions.set(id, { positions: evaluated.predicted, frameTime, model });
  actual.set(job.heldOut, { positions: evaluated.actual, frameTime });
  for (const oldest of predictions.keys()) {
    if (predictions.size <= MOST_MOTIONS) break;
    predictions.delete(oldest);
  }
}
