import { describe, expect, it } from "vitest";
import { initialSettings } from "../settings/settings";
import type { Finished, Job, Results } from "../engine/whole-protocol";
import { candidates, inOrder, jobKey, jobs, openJobs, sameSetting, secondsLeft, share, type StudyJob } from "./jobs";

const settings = (change: Partial<ReturnType<typeof initialSettings>> = {}) => ({ ...initialSettings(), ...change });

describe("what a comparison asks for", () => {
  it("is every model with every setting of its kind", () => {
    const found = candidates(
      settings({ models: ["vcgpdm", "map-gpdm", "dmp-discrete"], ips: [4, 8], bases: [10, 20, 40] }),
      2,
    );
    expect(found.map(({ model }) => model)).toEqual([
      "vcgpdm",
      "vcgpdm",
      "map-gpdm",
      "dmp-discrete",
      "dmp-discrete",
      "dmp-discrete",
    ]);
    expect(found[1]).toMatchObject({ dynamics_ips: 8, pose_ips: 8 });
  });

  it("holds each trial out in turn, with all models before the next, and seeds only where there are some", () => {
    const asked = jobs(settings({ models: ["vgpdm", "tmp"], ips: [8], seeds: 2, seed: 7 }), 3, 2);
    expect(asked.map(({ held_out, candidate, seed }) => [held_out, candidate.model, seed])).toEqual(
      [1, 2, 3].flatMap((fold) => [
        [fold, "vgpdm", 7],
        [fold, "vgpdm", 8],
        [fold, "tmp", 0],
      ]),
    );
    expect(asked.every(({ training_trials }) => training_trials === 2)).toBe(true);
  });

  it("can be one trial held out", () => {
    expect(jobs(settings({ models: ["tmp"], heldOut: 2 }), 3, 2).map(({ held_out }) => held_out)).toEqual([2]);
    // A trial that is not there cannot be: then each is.
    expect(jobs(settings({ models: ["tmp"], heldOut: 5 }), 3, 2)).toHaveLength(3);
  });

  it("trains the two models whose growth the paper shows on fewer trials too", () => {
    const asked = jobs(
      settings({ models: ["vcgpdm", "map-cgpdm", "tmp"], ips: [4, 8, 12], heldOut: 1, growth: true }),
      5,
      2,
    );
    const fewer = asked.filter(({ training_trials }) => training_trials < 4);
    expect(fewer.map(({ candidate, training_trials }) => [candidate.model, training_trials])).toEqual(
      ["vcgpdm", "map-cgpdm"].flatMap((model) => [1, 2, 3].map((count) => [model, count])),
    );
    // The same settings as among the whole: otherwise the times could not be compared.
    const whole = new Set(
      asked.filter(({ training_trials }) => training_trials === 4).map(({ candidate }) => JSON.stringify(candidate)),
    );
    expect(fewer.every(({ candidate }) => whole.has(JSON.stringify(candidate)))).toBe(true);
  });
});

describe("a body of one part", () => {
  it("has no coupled models: they would be the others again", () => {
    expect(
      candidates(settings({ models: ["vcgpdm", "vgpdm", "map-cgpdm"], ips: [8] }), 1).map(({ model }) => model),
    ).toEqual(["vgpdm"]);
  });
});

describe("what is still to be done", () => {
  const setting = (names: string[]): Results["setting"] =>
    ({
      trials: names.map((name) => ({ name, sha256: name.replace(".bvh", "") })),
      parts: [],
      frames_per_second: 30,
      start_frames: 5,
    }) as Results["setting"];
  const outcome = {} as NonNullable<Finished["outcome"]>;
  const of = (asked: Job[], done: number): Results =>
    ({
      format: "",
      version: 1,
      setting: setting(["a", "b", "c"]),
      finished: asked.slice(0, done).map((job) => ({ job, engine: "", outcome, failure: null })),
    }) as unknown as Results;
  const asked = jobs(settings({ models: ["tmp", "dmp-rhythmic"] }), 3, 2);

  it("is all without results", () => {
    expect(openJobs(asked, null)).toEqual(asked);
  });

  it("is never what has an outcome, but for the first trial's motions", () => {
    const known = of(asked, 4);
    const motions = new Map(
      asked.slice(0, 2).map((job) => [jobKey(job), { positions: new Float32Array(0), frameTime: 1 }]),
    );
    expect(openJobs(asked, { results: known, predictions: motions })).toEqual(asked.slice(4));
    // From a file: no motions; those of the first trial are made, the other trials' are not.
    expect(openJobs(asked, { results: known, predictions: new Map() })).toEqual([
      ...asked.slice(0, 2),
      ...asked.slice(4),
    ]);
  });

  it("is what failed before, too", () => {
    const known = of(asked, 6);
    known.finished[5] = { ...known.finished[5]!, outcome: null, failure: "out of memory" };
    const motions = new Map(asked.map((job) => [jobKey(job), { positions: new Float32Array(0), frameTime: 1 }]));
    expect(openJobs(asked, { results: known, predictions: motions })).toEqual([asked[5]]);
  });

  it("goes by what the trials are, not by what they are called", () => {
    expect(sameSetting(setting(["a", "b"]), setting(["a.bvh", "b.bvh"]))).toBe(true);
    expect(sameSetting(setting(["a", "b"]), setting(["b", "a"]))).toBe(false);
    expect(sameSetting(setting(["a"]), { ...setting(["a"]), frames_per_second: 25 })).toBe(false);
  });
});

describe("a job's key", () => {
  it("is the same in whatever order its entries stand", () => {
    const a = { candidate: { model: "dmp-discrete" as const, bases: 10 }, held_out: 1, training_trials: 2, seed: 0 };
    const b = { seed: 0, training_trials: 2, held_out: 1, candidate: { bases: 10, model: "dmp-discrete" as const } };
    expect(jobKey(a)).toBe(jobKey(b));
    expect(jobKey({ ...a, seed: 1 })).not.toBe(jobKey(a));
  });
});

it("lists models in the order of tables, whichever was finished first", () => {
  const asked = jobs(
    settings({
      models: ["vcgpdm", "vgpdm", "tmp", "dmp-rhythmic"],
      ips: [4, 12],
      bases: [5, 10],
      seeds: 2,
      heldOut: 1,
    }),
    3,
    2,
  );
  expect([...asked].reverse().sort(inOrder)).toEqual(asked);
});

describe("how long a comparison still takes", () => {
  const job = (state: StudyJob["state"], fraction = 0, elapsed = 0): StudyJob => ({
    job: { candidate: { model: "tmp", primitives: null }, held_out: 1, training_trials: 2, seed: 0 },
    state,
    fraction,
    elapsed,
    why: "",
  });

  it("follows from the jobs that are done or under way", () => {
    expect(secondsLeft([job("waiting")], 1)).toBeNull();
    expect(secondsLeft([job("done", 1, 4), job("waiting"), job("waiting")], 1)).toBeCloseTo(8);
    expect(secondsLeft([job("done", 1, 4), job("waiting"), job("waiting")], 2)).toBeCloseTo(4);
    // One job alone cannot be shared between workers.
    expect(secondsLeft([job("running", 0.25, 4)], 2)).toBeCloseTo(12);
    expect(secondsLeft([job("done", 1, 4), job("cancelled", 0.5, 2)], 1)).toBe(0);
  });

  it("counts work, not jobs", () => {
    const slow = {
      ...job("waiting"),
      job: {
        ...job("waiting").job,
        candidate: { model: "map-cgpdm" as const, latent: 3, order: 2, max_iterations: 10, balanced: false },
      },
    };
    expect(share([job("done", 1, 1), slow])).toBeLessThan(0.1);
    expect(share([job("failed", 0.2, 1), job("done", 1, 1)])).toBe(1);
  });
});
