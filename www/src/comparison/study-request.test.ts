import { expect, it } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import type { Evaluated, Job } from "../engine/whole-protocol";
import { initialSettings } from "../settings/settings";
import { keepMotions, newEntry, withResult } from "./comparison-entry";
import { type ComparisonRequest, planOf } from "./comparison-request";
import { smallClip } from "./small-clip.fake";
import { studyRequestOf } from "./study-request";

const clips = [smallClip(1), smallClip(2)];
const settings = { parts: [{ name: "whole", joints: [0, 1] }], framesPerSecond: 10 };
const request = { clips, titles: ["one", "two"], settings } as unknown as ComparisonRequest;
const chosen = { latent: 1, ips: [2], heldOut: 1, seeds: 2, comparedIterations: 5 };
const plan = planOf({ ...initialSettings(), ...chosen, models: ["vgpdm"] });

/** Two trainings on one trial that predict the other, and their results. */
const { results, trained } = await new HeldWorkers().desk.run(async (worker) => {
  const { jobs, ...planned } = await worker.planComparison(clips, settings, plan, null);
  const trained: { id: string; job: Job; found: Evaluated }[] = [];
  let { results } = planned;
  for (const { id, job } of jobs) {
    const found = await worker.evaluate({ ...job, clips, settings }, () => {}, new AbortController().signal);
    trained.push({ id, job, found: found! });
    results = withResult(results, (await worker.addOutcome(results.text, job, found!.outcome))!);
  }
  return { results, trained };
});

it("has every model that was trained in this visit, and the recorded trial", () => {
  const entry = newEntry(request, results);
  expect(studyRequestOf(entry)).toBe(null);
  for (const { id, job, found } of trained) keepMotions(entry, id, job, found);
  const study = studyRequestOf(entry);
  expect(study?.generated.map(({ seed, trial, name }) => [seed, trial, name])).toEqual([
    [0, 1, "two"],
    [1, 1, "two"],
  ]);
  expect(study?.generated.map(({ outcome }) => outcome)).toEqual(trained.map(({ found }) => found.outcome));
  expect(study?.natural.map(({ trial, name }) => [trial, name])).toEqual([[1, "two"]]);
  expect(study?.body.id).toBe(1);
});

it("is impossible for results from a file, which have no movements", () => {
  expect(studyRequestOf(newEntry(null, results))).toBe(null);
});
