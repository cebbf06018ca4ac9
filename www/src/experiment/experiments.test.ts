import { describe, expect, it } from "vitest";
import { type ExperimentRun, headline, inOrder, newRun, readings, tally } from "./experiments";
import { restOf, shareOf } from "../training/runs";
import type { TrainedExperiment } from "../engine/whole-protocol";

const RULES = { much: 10, alike: 4 };
const DRIVEN = { ...RULES, drive: 0.1 };
const CONTROL = { ...RULES, drive: 0 };

/** Findings with these ratios, judged as the program judges them. */
function findings(back: number, forth: number, driving = true): TrainedExperiment {
  const forthIsRight = driving ? forth >= 1 / RULES.alike && forth <= RULES.alike : forth >= RULES.much;
  return {
    alpha: [
      [0.1, 0.1 * forth],
      [0.1 * back, 0.1],
    ],
    weights: [
      [1 - 1 / (1 + back), 1 / (1 + forth)],
      [1 / (1 + back), 1 - 1 / (1 + forth)],
    ],
    verdict: { back, forth, backIsRight: back >= RULES.much, forthIsRight },
    model: { learned: [], explained: [1, 1], poseIps: [], dynamicsIps: [], path: [], generated: [] },
    text: "",
    start: { bound: 0, mse: 1 },
    now: { bound: 1, mse: 0 },
  };
}

const ended = (seed: number, more: Partial<ExperimentRun> = {}): ExperimentRun => ({
  ...newRun({ seed, driving: true, points: 10 }),
  state: "done",
  fraction: 1,
  ...more,
});

describe("the sentences about a result", () => {
  it("say that the truth was found", () => {
    expect(headline(findings(1800, 2), true)).toMatch(/^Found: part 1 drives part 2/);
    expect(headline(findings(1800, 2000, false), false)).toBe("Found: neither part drives the other.");
    const [back, forth] = readings(findings(1847.7, 2), DRIVEN);
    expect(back).toEqual({
      right: true,
      words: "α from 2 to 1 is 1,848 times α from 1 to 1: part 2 counts for nothing in part 1. That is true.",
    });
    expect(forth).toEqual({
      right: true,
      words: "α from 1 to 2 is 2.00 times α from 2 to 2: part 1 has a say in part 2. That is true.",
    });
  });

  it("say what was missed, and by how much", () => {
    expect(headline(findings(1800, 4.18), true)).toMatch(/^Missed/);
    expect(readings(findings(1800, 4.18), DRIVEN)[1]).toEqual({
      right: false,
      words:
        "α from 1 to 2 is 4.18 times α from 2 to 2: too small a say of part 1 in part 2; up to 4 times counts as found.",
    });
    expect(readings(findings(1800, 0.1), DRIVEN)[1]!.words).toMatch(
      /more say in part 2 than part 2 itself, which is not so/,
    );
    expect(readings(findings(1.2, 2), DRIVEN)[0]).toMatchObject({
      right: false,
      words: expect.stringContaining("a say in part 1, which it has not; 10 times or more"),
    });
    expect(readings(findings(1800, 2, false), CONTROL)[1]).toMatchObject({
      right: false,
      words: expect.stringContaining("a say in part 2, which it has not; 10 times or more"),
    });
  });
});

describe("several trainings", () => {
  const runs = [
    ended(8, { findings: findings(1900, 5) }),
    ended(0, { findings: findings(1800, 2000, false), driving: false }),
    ended(3, { findings: findings(1800, 2) }),
    ended(5, { findings: findings(1800, 2), state: "cancelled" }),
    ended(6, { state: "failed" }),
  ];

  it("are counted without stopped and failed ones", () => {
    expect(tally(runs)).toBe(
      "Found with 1 of 2 seeds. Without driving, found with 1 of 1 seed. 1 stopped early, not counted.",
    );
    expect(tally([])).toBe("");
  });

  it("are sorted: with driving first, then by seed", () => {
    expect(inOrder(runs).map(({ seed, driving }) => [seed, driving])).toEqual([
      [3, true],
      [5, true],
      [6, true],
      [8, true],
      [0, false],
    ]);
  });
});

describe("the remaining time", () => {
  const running = ended(1, { state: "running", fraction: 0.25, elapsed: 2 });

  it("is unknown at the beginning", () => {
    expect(restOf([newRun({ seed: 0, driving: true, points: 10 })], 1)).toBeNull();
  });

  it("expects waiting trainings to be as long as running ones", () => {
    expect(restOf([running], 1)).toBeCloseTo(6);
    expect(restOf([running, newRun({ seed: 2, driving: true, points: 10 })], 1)).toBeCloseTo(14);
    expect(restOf([running, newRun({ seed: 2, driving: true, points: 10 })], 2)).toBeCloseTo(8);
  });

  it("counts ended trainings as done", () => {
    expect(shareOf([running, ended(2), ended(3, { state: "failed", fraction: 0 })])).toBeCloseTo(0.75);
    expect(shareOf([])).toBe(0);
  });
});
