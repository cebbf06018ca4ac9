// The exercises with the model that the page opens with, measured by the library.
import { expect, it } from "vitest";
import type { BodyReport, Couplings, Reading } from "../engine/protocol";
import { startModel } from "../engine/start-model.fake";
import { largestDistance } from "../scene/motion";
import { EXERCISES } from "../settings/settings";
import { type ExerciseName, EXERCISE_NAMES, judge } from "./exercises";

const { model, info } = await startModel();
const frames = Math.round(20 / info.frameTime);
const settled = Math.round(5 / info.frameTime);

function roll(alpha: Couplings, reading: Reading) {
  const rollout = model.rollout({ frames, sequence: 0, alpha, reading });
  const positions = rollout.positions();
  const motion = { positions, frames, nodes: info.figure.nodes.length, frameTime: info.frameTime };
  const request = { frames, sequence: 0, alpha, reading };
  const report = { measures: rollout.measures(settled), health: rollout.health(), request } as BodyReport;
  return { motion, report };
}
const learned = roll(info.alpha, "as-learned");

/** The verdict on the first model whose couplings "source.target" are multiplied by these factors. */
function verdict(exercise: ExerciseName, factors: Record<string, number>, reading: Reading) {
  const alpha = info.alpha.map((row, source) =>
    row.map((value, target) => value * (factors[`${source}.${target}`] ?? 1)),
  );
  const { motion, report } = roll(alpha, reading);
  return judge(exercise, {
    isStartModel: true,
    learned: info.alpha,
    alpha,
    reports: { now: report, learned: learned.report },
    apart: 1000 * largestDistance(motion, learned.motion),
    points: 12,
  });
}

const SOLUTIONS: Record<Exclude<ExerciseName, "few">, [Record<string, number>, Reading]> = {
  pace: [{ "0.1": 100 }, "re-inferred"],
  pose: [{ "0.1": 10 }, "as-learned"],
  ratio: [{ "0.1": 2, "1.1": 2 }, "as-learned"],
  idle: [{ "1.0": 100 }, "re-inferred"],
  halt: [{ "0.0": 1000 }, "as-learned"],
};

it("has a task for each address", () => {
  expect(EXERCISE_NAMES).toHaveLength(EXERCISES);
});

for (const [exercise, solution] of Object.entries(SOLUTIONS))
  it(`takes the solution of "${exercise}", and neither the walk as learned nor the solution of another`, () => {
    const name = exercise as keyof typeof SOLUTIONS;
    expect(verdict(name, ...solution)).toMatchObject({ isSolved: true });
    expect(verdict(name, {}, "as-learned")).toMatchObject({ isSolved: false });
    for (const [other, [factors, reading]] of Object.entries(SOLUTIONS))
      if (other !== exercise)
        expect(verdict(name, factors, reading), other).toMatchObject({ isSolved: false });
  });

it("takes nearly equal factors of a pointer, and no other ratio", () => {
  expect(verdict("ratio", { "0.1": 2.2, "1.1": 2.24 }, "as-learned")).toMatchObject({ isSolved: true });
  expect(verdict("ratio", { "0.1": 2.2, "1.1": 2.6 }, "as-learned")).toMatchObject({ isSolved: false });
  expect(verdict("ratio", { "0.1": 2, "1.1": 2 }, "re-inferred").findings.at(-1)?.name).toBe("reading");
});

it("wants a trained model of few points that moves on", () => {
  const facts = {
    learned: [],
    alpha: [],
    apart: 0,
    reports: { now: learned.report, learned: learned.report },
  };
  const few = (points: number, isStartModel = false) =>
    judge("few", { ...facts, points, isStartModel }).isSolved;
  expect([few(6), few(7), few(6, true)]).toEqual([true, false, false]);
  const still = { ...learned.report, health: { ...learned.report.health, state: "stands-still" as const } };
  const reports = { now: still, learned: learned.report };
  expect(judge("few", { ...facts, reports, points: 6, isStartModel: false }).isSolved).toBe(false);
});
