import { expect, it } from "vitest";
import { clip, evaluated, resultsOf } from "../engine/whole-workers.fake";
import type { Job } from "../engine/whole-protocol";
import { keepMotions, newEntry } from "./comparison-entry";
import type { ComparisonRequest } from "./comparison-request";
import { studyRequestOf } from "./study-request";

const setting = {
  trials: [clip(1), clip(2)].map(({ id }) => ({ name: `clip ${id}`, sha256: "", piece: null })),
};
const request = { clips: [clip(1), clip(2)], titles: ["one", "two"], settings: { framesPerSecond: 30 } };

function entryOf(jobs: readonly Job[], objectives: readonly number[]) {
  const results = resultsOf({ ...setting, parts: [], framesPerSecond: 30, startFrames: 5 }, jobs);
  results.finished.forEach((finished, i) => {
    finished.outcome = { ...evaluated.outcome, objective: objectives[i] ?? 0 };
  });
  return newEntry(request as unknown as ComparisonRequest, results);
}
const job = (seed: number, primitives: number): Job => ({
  ...{ candidate: { model: "tmp", primitives }, heldOut: 1, trainingTrials: 1, seed },
});

it("has every model that was trained in this visit, and the recorded trial", () => {
  const jobs = [job(0, 3), job(1, 3)];
  const entry = entryOf(jobs, [5, 7]);
  expect(studyRequestOf(entry)).toBe(null);
  entry.results.finished.forEach(({ id, job }) => keepMotions(entry, id, job, evaluated));
  const request = studyRequestOf(entry);
  expect(request?.generated.map(({ seed, trial, name }) => [seed, trial, name])).toEqual([
    [0, 1, "two"],
    [1, 1, "two"],
  ]);
  expect(request?.generated.map(({ outcome }) => outcome.objective)).toEqual([5, 7]);
  expect(request?.natural.map(({ trial, name }) => [trial, name])).toEqual([[1, "two"]]);
  expect(request?.body.id).toBe(1);
});

it("is impossible for results from a file, which have no movements", () => {
  const { results } = entryOf([job(0, 3)], [1]);
  expect(studyRequestOf(newEntry(null, results))).toBe(null);
});
