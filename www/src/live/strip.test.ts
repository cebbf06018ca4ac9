import { expect, it } from "vitest";
import type { TracePoint } from "./live-store";
import { distanceLines, phaseDifference, phaseLines, actionText } from "./strip";

const point = (frame: number, ...phases: number[]): TracePoint => ({
  frame,
  phases,
  distances: phases.map(() => 0.1),
});

it("takes the shorter way round between two phases", () => {
  expect(phaseDifference(0.9, 0.1)).toBeCloseTo(-0.2);
  expect(phaseDifference(0.1, 0.9)).toBeCloseTo(0.2);
  expect(phaseDifference(0.3, 0.3)).toBeCloseTo(0);
});

it("breaks the line of a phase where it jumps", () => {
  const lines = phaseLines([point(0, 0, 0.4), point(1, 0, 0.48), point(2, 0, 0.55), point(3, 0, 0.6)]);
  expect(lines).toHaveLength(1);
  expect(lines[0]?.map((piece) => piece.map(({ frame }) => frame))).toEqual([
    [0, 1],
    [2, 3],
  ]);
});

it("has no lines for a model without a cycle", () => {
  const trace = [{ frame: 0, phases: [], distances: [] }];
  expect(phaseLines(trace)).toEqual([]);
  expect(distanceLines(trace)).toEqual([]);
});

it("names the coupling that is cut", () => {
  const cut = { kind: "cut" as const, source: 0, target: 1, from: 3, to: null };
  expect(actionText([cut], ["lower", "upper"])).toBe("lower → upper is cut");
  expect(actionText([{ ...cut, to: 9 }], ["lower", "upper"])).toBeNull();
  expect(actionText([cut, { ...cut, source: 1 }], ["lower", "upper"])).toBe("2 couplings are cut");
});

it("says who moves a part, unless a coupling is cut", () => {
  const names = ["lower", "upper"];
  const drive = { kind: "drive" as const, part: 0, from: 2, to: null };
  expect(actionText([drive], names)).toBe("You move lower. The others follow as the couplings say.");
  expect(actionText([{ ...drive, to: 3 }], names)).toBeNull();
  const record = { kind: "record" as const, part: 1, key: "a", title: "Walk 1", from: 4, to: null };
  expect(actionText([drive, record], names)).toBe("A recording moves upper: Walk 1. Outline: the recording.");
  const push = { kind: "push" as const, part: 0, began: 4, from: 9 };
  expect(actionText([push], names)).toBeNull();
  expect(actionText([{ ...push, held: true }], names)).toMatch(/^You move lower/);
  const cut = { kind: "cut" as const, source: 0, target: 1, from: 3, to: null };
  expect(actionText([cut, drive], names)).toBe("lower → upper is cut");
});
