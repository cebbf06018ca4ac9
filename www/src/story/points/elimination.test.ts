import { expect, it } from "vitest";
import type { ModelInfo } from "../../engine/protocol";
import { allPoints, bestChoice, choices, count, keptOf, toggled } from "./elimination";

const info = {
  parts: [{ poseIps: 2 }, { poseIps: 3 }],
  dynamicsIps: [
    [2, 1],
    [1, 2],
  ],
} as unknown as ModelInfo;

it("takes points of the legs away and leaves those of all other maps", () => {
  const fewer = toggled(allPoints(info), "steps", 0)!;
  expect(count(fewer)).toBe(3);
  expect(keptOf(info, fewer)).toEqual({
    poses: [
      [0, 1],
      [0, 1, 2],
    ],
    dynamics: [
      [[1], [0]],
      [[0], [0, 1]],
    ],
  });
  expect(toggled(fewer, "steps", 0)).toEqual(allPoints(info));
});

it("keeps the last point of a map", () => {
  const last = { poses: [1], steps: [0, 1] };
  expect(toggled(last, "poses", 1)).toBeNull();
  expect(choices(last)).toEqual([
    { poses: [1], steps: [1] },
    { poses: [1], steps: [0] },
  ]);
});

it("takes the point away whose loss costs the bound least", () => {
  const all = choices({ poses: [0, 1], steps: [5] });
  expect(bestChoice(all, [-3, -1])).toEqual({ poses: [0], steps: [5] });
});
