import { expect, it } from "vitest";
import type { ModelView } from "../engine/protocol";
import { couplingsOf, presetsOf, START_PRESETS } from "./presets";

/** As much of a model as presets look at. */
function info(names: string[], alpha: number[][]): ModelView["info"] {
  return { parts: names.map((name) => ({ name })), alpha } as ModelView["info"];
}

it("the presets of the first model fit it, and one of them is as learned", () => {
  const first = info(
    ["lower", "upper"],
    [
      [0.01, 0.1],
      [10, 0.04],
    ],
  );
  expect(new Set(START_PRESETS.map(({ id }) => id)).size).toBe(START_PRESETS.length);
  const changes = START_PRESETS.map((preset) => couplingsOf(preset, first));
  expect(changes.every((changed) => changed !== null)).toBe(true);
  expect(changes.filter((changed) => Object.keys(changed ?? {}).length === 0)).toHaveLength(1);
});

it("any model has two presets for each part", () => {
  const names = ["legs", "trunk", "left arm"];
  const presets = presetsOf(names);
  expect(presets.map(({ name }) => name).slice(4)).toEqual(["Left arm on its own", "Left arm follows the others"]);
  expect(new Set(presets.map(({ id }) => id)).size).toBe(6);
  const model = info(names, [
    [1, 2, 3],
    [4, 5, 6],
    [7, 8, 9],
  ]);
  expect(couplingsOf(presets[4]!, model)).toEqual({ "0.2": 3000, "1.2": 6000 });
  expect(couplingsOf(presets[5]!, model)).toEqual({ "2.2": 9000 });
});

it("a model of one part has none, and one that lacks a part cannot take a preset", () => {
  expect(presetsOf(["body"])).toEqual([]);
  expect(
    couplingsOf(
      presetsOf(["legs", "arms"])[0]!,
      info(
        ["legs", "trunk"],
        [
          [1, 1],
          [1, 1],
        ],
      ),
    ),
  ).toBeNull();
});
