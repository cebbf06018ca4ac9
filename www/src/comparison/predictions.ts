// The predictions that can be shown side by side, and the chosen ones.
import type { FinishedJob, Job, ModelSummary } from "../engine/whole-protocol";
import type { Motion } from "../engine/protocol";
import type { Positions, PredictedMotion, ReadonlyEntry } from "./comparison-entry";

/** More columns would be too narrow to see. */
export const MOST_COLUMNS = 4;

/** A model's prediction of a trial. */
export interface Prediction {
  /** The key of the model with its settings and seed, the same for all held-out trials. */
  key: string;
  finished: FinishedJob;
  predicted: PredictedMotion;
  /** The differences from other models of its kind; may be empty. */
  label: string;
}

// The program writes equal candidates as equal texts.
const textOf = (candidate: ModelSummary["candidate"]): string => JSON.stringify(candidate);

export function labelOf(
  { candidate, seed }: Job,
  finished: readonly FinishedJob[],
  models: readonly ModelSummary[],
): string {
  const label = models.find((summary) => textOf(summary.candidate) === textOf(candidate))?.label ?? "";
  const alike = finished.filter(({ job }) => job.candidate.model === candidate.model);
  const severalSeeds = new Set(alike.map(({ job }) => job.seed)).size > 1;
  return [label, severalSeeds ? `seed ${seed}` : ""].filter(Boolean).join(", ");
}

/** The trials with predictions. */
export function foldsOf({ results, predictions }: ReadonlyEntry): number[] {
  const known = results.finished.filter(({ id }) => predictions.has(id));
  return [...new Set(known.map(({ job }) => job.heldOut))].sort((a, b) => a - b);
}

/** The predictions of a trial by models trained on all other trials, in the order of the tables. */
export function predictionsOf({ results, predictions }: ReadonlyEntry, fold: number): Prediction[] {
  const { finished, comparison } = results;
  return finished.flatMap((entry) => {
    const { id, job } = entry;
    const predicted = predictions.get(id);
    if (job.heldOut !== fold || !predicted) return [];
    const key = `${textOf(job.candidate)} ${job.seed}`;
    return [{ key, finished: entry, predicted, label: labelOf(job, finished, comparison.models) }];
  });
}

/** The predictions that the visitor has chosen, or else the first of each kind of model. */
export function chosenOf(predictions: readonly Prediction[], picked: readonly string[] | null): Prediction[] {
  const chosen = picked?.flatMap((key) => predictions.filter((prediction) => prediction.key === key)) ?? [];
  if (chosen.length > 0) return chosen.slice(0, MOST_COLUMNS);
  const kinds = new Map<string, Prediction>();
  for (const prediction of predictions) {
    const { model } = prediction.finished.job.candidate;
    if (!kinds.has(model)) kinds.set(model, prediction);
  }
  return [...kinds.values()].slice(0, MOST_COLUMNS);
}

/** The keys after one was added or removed; unchanged when that would leave none or too many. */
export function toggled(keys: readonly string[], key: string): readonly string[] {
  const next = keys.includes(key) ? keys.filter((other) => other !== key) : [...keys, key];
  return next.length >= 1 && next.length <= MOST_COLUMNS ? next : keys;
}

export const motionOf = ({ positions, frameTime }: Positions, nodes: number): Motion => ({
  positions,
  nodes,
  frameTime,
  frames: positions.length / (3 * nodes),
});
