import { describe, expect, it } from "vitest";
import type { Job, PlannedJob } from "../engine/whole-protocol";
import { costOf, type JobProgress, openJobs, secondsLeft, share, summary } from "./jobs";

const jobOf = (heldOut: number, trainingTrials: number): Job => ({
  candidate: { model: "tmp", primitives: null },
  heldOut,
  trainingTrials,
  seed: 0,
});

it("says that the time depends on the machine when the estimate is short, before Compare is pressed", () => {
  const jobs = [1, 2].map((heldOut) => ({ id: `fold ${heldOut}`, job: jobOf(heldOut, 2), done: false }));
  const costs = jobs.map(() => ({ seconds: 1, bytes: 0 }));
  expect(costOf(jobs, { jobs, costs }, 2).words).toBe(
    "How long this takes depends on the machine. The time left is shown while it runs.",
  );
  expect(costOf([], { jobs, costs }, 2).words).toBe("");
  const long = costs.map((cost) => ({ ...cost, seconds: 200 }));
  expect(costOf(jobs, { jobs, costs: long }, 2).words).toMatch(/^At most about 3 min 20 s/);
});

describe("open jobs", () => {
  const planned = (done: boolean): PlannedJob[] =>
    [1, 2, 3].map((heldOut) => ({ id: `fold ${heldOut}`, job: jobOf(heldOut, 2), done }));
  const folds = (jobs: PlannedJob[]) => jobs.map(({ job }) => job.heldOut);

  it("are all without an outcome", () => {
    expect(folds(openJobs(planned(false), new Map()))).toEqual([1, 2, 3]);
    const [first, ...others] = planned(true);
    expect(folds(openJobs([{ ...first!, done: false }, ...others], new Map([["fold 1", {}]])))).toEqual([1]);
  });

  it("are also those without a motion to show, of the first trial only", () => {
    expect(folds(openJobs(planned(true), new Map()))).toEqual([1]);
    expect(folds(openJobs(planned(true), new Map([["fold 1", {}]])))).toEqual([]);
  });

  it("are never finished trainings on fewer trials, whose motions are not shown", () => {
    const fewer = { id: "fewer", job: jobOf(1, 1), done: true };
    expect(openJobs([...planned(true), fewer], new Map([["fold 1", {}]]))).toEqual([]);
  });

  it("are none when nothing is asked for", () => {
    expect(openJobs([], new Map())).toEqual([]);
  });
});

describe("the remaining time of a comparison", () => {
  const progress = (state: JobProgress["state"], fraction = 0, elapsed = 0): JobProgress => ({
    id: "",
    job: jobOf(1, 2),
    state,
    fraction,
    elapsed,
    why: "",
  });

  it("follows from finished and running jobs", () => {
    expect(secondsLeft([progress("waiting")], 1)).toBeNull();
    expect(secondsLeft([progress("done", 1, 4), progress("waiting"), progress("waiting")], 1)).toBeCloseTo(8);
    expect(secondsLeft([progress("done", 1, 4), progress("waiting"), progress("waiting")], 2)).toBeCloseTo(4);
    // Workers cannot share one job.
    expect(secondsLeft([progress("running", 0.25, 4)], 2)).toBeCloseTo(12);
    expect(secondsLeft([progress("done", 1, 4), progress("cancelled", 0.5, 2)], 1)).toBe(0);
  });

  it("counts work, not jobs", () => {
    const candidate = {
      model: "map-cgpdm" as const,
      latent: 3,
      order: 2,
      maxIterations: 10,
      balanced: false,
    };
    const slow: JobProgress = { ...progress("waiting"), job: { ...jobOf(1, 2), candidate } };
    expect(share([progress("done", 1, 1), slow])).toBeLessThan(0.1);
    expect(share([progress("failed", 0.2, 1), progress("done", 1, 1)])).toBe(1);
  });

  it("is followed by a sentence about the end", () => {
    expect(summary([])).toBe("All of this was finished before.");
    expect(summary([progress("done"), progress("failed"), progress("cancelled")])).toBe(
      "1 of 3 trainings done, 1 failed; the others were cancelled.",
    );
  });
});
