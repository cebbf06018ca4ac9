// The request for a study of perceived naturalness: the trials of a comparison, and the predictions of the
// models trained in this visit.
import type { GeneratedMovement, StudyRequest } from "../engine/whole-protocol";
import type { ReadonlyEntry } from "./comparison-entry";
import { compareWords } from "./view-words";

/** Null: no model was trained in this visit, and results from a file have no movements. */
export function studyRequestOf({
  request,
  titles,
  results,
  predictions,
  actual,
}: ReadonlyEntry): StudyRequest | null {
  const [body] = request?.clips ?? [];
  if (!request || !body) return null;
  const named = (trial: number, frameTime: number) => ({ trial, name: titles[trial] ?? "", frameTime });
  // Of several seeds the study takes the best: the library's rule.
  const generated = results.finished.flatMap(({ id, job, outcome }): GeneratedMovement[] => {
    const predicted = predictions.get(id);
    if (!predicted || !outcome) return [];
    const { positions, frameTime } = predicted;
    const { candidate, seed, heldOut } = job;
    return [{ ...named(heldOut, frameTime), positions, candidate, seed, outcome }];
  });
  const natural = [...actual].map(([trial, { positions, frameTime }]) => ({
    ...named(trial, frameTime),
    positions,
  }));
  if (generated.length === 0 || natural.length === 0) return null;
  const { framesPerSecond } = request.settings;
  return { title: compareWords().studyTitle, body, framesPerSecond, natural, generated };
}
