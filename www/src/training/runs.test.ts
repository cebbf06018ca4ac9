import { expect, it } from "vitest";
import { progress } from "../engine/documents.fake";
import { bestRun, dataOf, differences, type Run, secondsLeft, seedsFrom, share } from "./runs";

const settings = {
  parts: [
    { name: "lower", joints: [0, 1] },
    { name: "upper", joints: [2, 3] },
  ],
  latent: 3,
  dynamicsIps: 12,
  poseIps: 12,
  order: 2,
  framesPerSecond: 30,
  seed: 1,
  maxIterations: 100,
};

function run(change: Partial<Run> = {}, iteration = 0, best = 0): Run {
  const clips = [{ id: 1, title: "walk", source: { sample: "walk" }, first: 0, end: 90 }];
  const steps = iteration > 0 ? [progress(iteration, best)] : [];
  return {
    id: 1,
    settings,
    clips,
    state: "running",
    steps,
    elapsed: 0,
    ending: "",
    model: null,
    open: false,
    catchingUp: false,
    portion: 100,
    ...change,
  };
}

it("finds the highest bound, the first of equal ones", () => {
  expect(bestRun([])).toBeNull();
  const runs = [run({ id: 1 }), run({ id: 2 }, 5, -20), run({ id: 3 }, 5, -10), run({ id: 4 }, 9, -10)];
  expect(bestRun(runs)?.id).toBe(3);
});

it("counts seeds up from the first, and begins again at 0 after the largest", () => {
  expect(seedsFrom(7, 3)).toEqual([7, 8, 9]);
  expect(seedsFrom(4294967295, 2)).toEqual([4294967295, 0]);
});

it("names the settings that differ, but not the seed", () => {
  const other = (change: object) => run({ settings: { ...settings, ...change } });
  const heads = (...runs: Run[]) => differences(runs).map(({ head }) => head);
  expect(heads(run(), other({ seed: 2 }))).toEqual([]);
  expect(heads(run(), other({ latent: 2 }), other({ dynamicsIps: 14, seed: 5 }))).toEqual(["Q", "K"]);
  expect(heads(run(), run({ clips: [{ ...run().clips[0]!, end: 80 }] }))).toEqual(["Clips"]);
});

it("compares bounds of the same data only", () => {
  const other = (change: object) => dataOf(run({ settings: { ...settings, ...change } }));
  const same = dataOf(run());
  expect(other({ seed: 4, latent: 2, poseIps: 30 })).toBe(same);
  expect(other({ parts: [{ name: "whole", joints: [3, 2, 1, 0] }] })).toBe(same);
  expect(other({ parts: [{ name: "lower", joints: [0, 1] }] })).not.toBe(same);
  expect(other({ framesPerSecond: 15 })).not.toBe(same);
  expect(other({ poseWeight: 1 })).toBe(same);
  expect(other({ poseWeight: "balanced" })).not.toBe(same);
  expect(dataOf(run({ clips: [{ ...run().clips[0]!, first: 3 }] }))).not.toBe(same);
});

it("computes the done share and the remaining time on several workers", () => {
  const early = [run({ elapsed: 0.4 }, 2)];
  expect(secondsLeft(early, 1)).toBeNull();
  expect(secondsLeft([run({ elapsed: 10 }, 50)], 4)).toBeCloseTo(10);

  const waiting = () => run({ state: "waiting" });
  const runs = [run({ elapsed: 10 }, 50), run({ elapsed: 10 }, 50), waiting(), waiting(), waiting()];
  expect(share(runs)).toBeCloseTo(0.2);
  // Each training takes 20 s: 10 + 20 + 20 on one worker, 10 + 20 on the other.
  expect(secondsLeft(runs, 2)).toBeCloseTo(50);
  expect(secondsLeft(runs, 8)).toBeCloseTo(20);

  const ended = [run({ state: "done", elapsed: 12 }, 60), run({ state: "failed" }), run({ elapsed: 4 }, 20)];
  expect(share(ended)).toBeCloseTo(2.2 / 3);
  expect(secondsLeft(ended, 2)).toBeCloseTo(16);
});
