import { expect, it } from "vitest";
import type { ModelView } from "../engine/protocol";
import { words as german } from "../words/de/lab";
import { words as english } from "../words/en/lab";
import { couplingsOf, isPreset, type Preset, presetsOf, presetWords, START_PRESETS } from "./presets";

/** The fields of a model that presets read. */
function info(names: string[], alpha: number[][]): ModelView["info"] {
  return { parts: names.map((name) => ({ name })), alpha } as ModelView["info"];
}

it("fits the presets of the first model to its parts, one of them as learned", () => {
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

it("has words for each preset of the first model, and its own words for those of any model", () => {
  for (const { id } of START_PRESETS)
    for (const { start } of [english.presets, german.presets]) {
      expect(start[id]?.name, id).toMatch(/^\p{Lu}/u);
      expect(start[id]?.meaning, id).toMatch(/^\p{Lu}.*\.$/u);
    }
  expect(presetWords(START_PRESETS[0]!).meaning).toBe("Legs and arms as training coupled them.");
  expect(presetWords(presetsOf(["a", "b"])[0]!).meaning).toBe("The parts as training coupled them.");
});

it("offers a preset that exists at the head of the page", () => {
  expect(START_PRESETS.map(({ id }) => id)).toContain("arms-go");
});

it("recognises a preset by its couplings and reading, with the precision of a link", () => {
  const parts = info(
    ["lower", "upper"],
    [
      [1, 2],
      [3, 4],
    ],
  );
  const [learned, alone] = presetsOf(["lower", "upper"]) as [Preset, Preset];
  expect(isPreset(learned, parts, { alpha: {}, reading: "as-learned" })).toBe(true);
  expect(isPreset(learned, parts, { alpha: { "1.0": 7 }, reading: "re-inferred" })).toBe(false);
  expect(isPreset(alone, parts, { alpha: { "1.0": 1000.4 }, reading: "re-inferred" })).toBe(true);
  expect(isPreset(alone, parts, { alpha: { "1.0": 1000 }, reading: "as-learned" })).toBe(false);
  expect(isPreset(alone, parts, { alpha: { "1.0": 900 }, reading: "re-inferred" })).toBe(false);
  expect(isPreset(alone, parts, { alpha: { "1.0": 1000, "0.0": 2 }, reading: "re-inferred" })).toBe(false);
});

it("gives any model the preset as-learned and two presets for each part", () => {
  const names = ["legs", "trunk", "left arm"];
  const presets = presetsOf(names);
  expect(presets.map((preset) => presetWords(preset).name).slice(5)).toEqual([
    "Left arm alone",
    "Left arm by the others alone",
  ]);
  expect(new Set(presets.map(({ id }) => id)).size).toBe(7);
  const model = info(names, [
    [0.1, 0.2, 0.3],
    [0.4, 0.5, 0.6],
    [0.7, 0.8, 0.9],
  ]);
  expect(presets.map((preset) => couplingsOf(preset, model))).toEqual([
    {},
    { "1.0": 400, "2.0": 700 },
    { "0.0": 100 },
    { "0.1": 200, "2.1": 800 },
    { "1.1": 500 },
    { "0.2": 300, "1.2": 600 },
    { "2.2": 900 },
  ]);
});

it("gives none to a model of one part, and refuses a preset whose part is missing", () => {
  expect(presetsOf(["body"])).toEqual([]);
  expect(
    couplingsOf(
      presetsOf(["legs", "arms"])[1]!,
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
