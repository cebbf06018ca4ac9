import { expect, it } from "vitest";
import type { Job, ModelSummary } from "../engine/whole-protocol";
import { chosenOf, foldsOf, predictionsOf, toggled } from "./side-by-side";
import { newEntry } from "./comparison-entry";

const dmp = (bases: number, heldOut: number, seed = 0): Job => ({
  candidate: { model: "dmp-discrete", bases },
  heldOut,
  trainingTrials: 2,
  seed,
});
const tmp = (heldOut: number): Job => ({
  candidate: { model: "tmp", primitives: null },
  heldOut,
  trainingTrials: 2,
  seed: 0,
});

/** A comparison with these finished jobs; all but the named ones have predictions. */
function entryOf(jobs: Job[], without: Job[] = []) {
  const finished = jobs.map((job) => ({
    id: JSON.stringify(job),
    job,
    engine: "",
    outcome: null,
    failure: null,
  }));
  const models = jobs.map(({ candidate }) => ({
    candidate,
    label: "bases" in candidate ? `${candidate.bases} bases` : "",
  }));
  const comparison = {
    parts: [],
    models: models as ModelSummary[],
    correlations: [],
    growth: [],
    evidence: [],
    claims: [],
  };
  const setting = { trials: [], parts: [], framesPerSecond: 30, startFrames: 5 };
  const entry = newEntry(null, { text: "", setting, finished, comparison });
  for (const { id, job } of finished) {
    if (!without.includes(job))
      entry.predictions.set(id, { positions: new Float32Array(3), frameTime: 1, model: new Blob() });
  }
  return entry;
}

it("lists the trials with predictions", () => {
  const jobs = [tmp(3), tmp(1), tmp(2)];
  expect(foldsOf(entryOf(jobs, jobs.slice(2)))).toEqual([1, 3]);
});

it("gives a model the same name in each fold, with its differences from others", () => {
  const entry = entryOf([dmp(10, 1), dmp(10, 2), dmp(20, 1), tmp(1)]);
  const [first, second] = [predictionsOf(entry, 1), predictionsOf(entry, 2)];
  expect(first.map(({ label }) => label)).toEqual(["10 bases", "20 bases", ""]);
  expect(second.map(({ key }) => key)).toEqual([first[0]?.key]);
});

it("names seeds when there are several", () => {
  const entry = entryOf([dmp(10, 1, 4), dmp(10, 1, 5)]);
  expect(predictionsOf(entry, 1).map(({ label }) => label)).toEqual(["10 bases, seed 4", "10 bases, seed 5"]);
});

it("shows the first of each kind until the visitor chooses others, at most four", () => {
  const all = predictionsOf(entryOf([dmp(10, 1), dmp(20, 1), tmp(1)]), 1);
  const bases = (shown: typeof all) => shown.map(({ label }) => label);
  expect(bases(chosenOf(all, null))).toEqual(["10 bases", ""]);
  const [, second] = all;
  expect(bases(chosenOf(all, [second?.key ?? ""]))).toEqual(["20 bases"]);
  expect(bases(chosenOf(all, ["no such model"]))).toEqual(["10 bases", ""]);
});

it("neither removes the last nor adds a fifth", () => {
  expect(toggled(["a"], "a")).toEqual(["a"]);
  expect(toggled(["a", "b"], "a")).toEqual(["b"]);
  expect(toggled(["a", "b", "c", "d"], "e")).toEqual(["a", "b", "c", "d"]);
  expect(toggled(["a"], "b")).toEqual(["a", "b"]);
});
