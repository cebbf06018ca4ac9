import { describe, expect, it } from "vitest";
import type { Job, PlannedJob } from "../engine/whole-protocol";
import { type JobProgress, openJobs, secondsLeft, share, summary } from "./jobs";

const jobOf = (heldOut: number, trainingTrials: number): Job => ({
  candidate: { model: "tmp", primitives: null },
  heldOut,
  trainingTrials,
  seed: 0,
});

describe("what is still to be done", () => {
  const planned = (done: boolean): PlannedJob[] =>
    [1, 2, 3].map((heldOut) => ({ id: `fold ${heldOut}`, job: jobOf(heldOut, 2), done }));
  const folds = (jobs: PlannedJob[]) => jobs.map(({ job }) => job.heldOut);

  it("is all that has no outcome", () => {
    expect(folds(openJobs(planned(false), new Map()))).toEqual([1, 2, 3]);
    const [first, ...others] = planned(true);
    expect(folds(openJobs([{ ...first!, done: false }, ...others], new Map([["fold 1", {}]])))).toEqual([1]);
  });

  it("is what has no motion to show, too, but only of the first trial", () => {
    expect(folds(openJobs(planned(true), new Map()))).toEqual([1]);
    expect(folds(openJobs(planned(true), new Map([["fold 1", {}]])))).toEqual([]);
  });

  it("is never a finished training on fewer trials: its motion is not shown", () => {
    const fewer = { id: "fewer", job: jobOf(1, 1), done: true };
    expect(openJobs([...planned(true), fewer], new Map([["fold 1", {}]]))).toEqual([]);
  });

  it("is nothing where nothing is asked for", () => {
    expect(openJobs([], new Map())).toEqual([]);
  });
});

describe("how long a comparison still takes", () => {
  const progress = (state: JobProgress["state"], fraction = 0, elapsed = 0): JobProgress => ({
    id: "",
    job: jobOf(1, 2),
    state,
    fraction,
    elapsed,
    why: "",
  });

  it("follows from the jobs that are done or under way", () => {
    expect(secondsLeft([progress("waiting")], 1)).toBeNull();
    expect(secondsLeft([progress("done", 1, 4), progress("waiting"), progress("waiting")], 1)).toBeCloseTo(8);
    expect(secondsLeft([progress("done", 1, 4), progress("waiting"), progress("waiting")], 2)).toBeCloseTo(4);
    // One job alone cannot be shared between workers.
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

  it("ends in words", () => {
    expect(summary([])).toBe("All of this was finished before.");
    expect(summary([progress("done"), progress("failed"), progress("cancelled")])).toBe(
      "1 of 3 trainings done, 1 failed; the others were cancelled.",
    );
  });
});
