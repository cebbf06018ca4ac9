import { describe, expect, it } from "vitest";
import { type OnStage, stageWords } from "./stage-words";

const walking: OnStage = {
  kind: "model",
  clip: null,
  learnedFrom: ["35_01.bvh", "35_02.bvh", "35_03.bvh"],
  point: null,
  altered: false,
  preset: null,
  effect: null,
  live: false,
  twoReadings: false,
  learning: null,
};

describe("the words about the stage", () => {
  it("say of a model's motion that it was never recorded, and how many clips it was learned from", () => {
    const { title, text, lead } = stageWords(walking);
    expect(title).toBe("Made by the model");
    expect([text, lead].every((words) => words.includes("3 clips"))).toBe(true);
    expect(lead).toMatch(/never recorded/);
    expect(stageWords({ ...walking, learnedFrom: ["mine.bvh"] }).text).toBe("learned from mine");
  });

  it("never say of a clip that it was not recorded, or that the model made it", () => {
    for (const origin of ["made", "own"] as const) {
      const words = stageWords({
        ...walking,
        kind: "clip",
        clip: { title: "walk 1", origin },
        altered: true,
      });
      expect(JSON.stringify(words)).not.toMatch(/never recorded|by the model|outline/);
      expect([words.title, words.lead]).toEqual(["walk 1", expect.stringMatching(/^This is a clip/)]);
    }
  });

  it("say of the stored first seconds no number of clips that is not known yet", () => {
    const { text, lead } = stageWords({ ...walking, kind: "first", learnedFrom: null });
    expect([text, lead]).toEqual(["", "This motion was never recorded: a small model made it."]);
  });

  it("follow a training, changed couplings and an inducing point", () => {
    const learning = stageWords({ ...walking, learning: { iteration: 12, seed: 7 } });
    expect([learning.text, learning.lead]).toEqual([
      "Iteration 12, seed 7",
      expect.stringMatching(/is learning/),
    ]);
    expect(stageWords({ ...walking, altered: true }).title).toBe("Couplings changed");
    expect(stageWords({ ...walking, altered: true, twoReadings: true }).text).not.toMatch(/outline/);
    expect(stageWords({ ...walking, altered: true, live: true }).text).not.toMatch(/outline/);
    expect(stageWords({ ...walking, twoReadings: true }).text).toMatch(/change a coupling/);
    expect(stageWords({ ...walking, altered: true, point: "A pose of lower" }).text).toBe("A pose of lower");
  });

  it("promise no effect of a preset: its effect is measured, and not of a live motion", () => {
    const preset = { name: "Let the arms go", meaning: "The arms no longer hear the legs." };
    const altered = { ...walking, altered: true, preset };
    const { title, lead } = stageWords(altered);
    expect([title, lead]).toEqual([preset.name, preset.meaning]);
    const effect = { text: "Hands and feet out of step.", reading: "re-inferred" as const };
    expect(stageWords({ ...altered, effect }).lead).toBe(`${preset.meaning} ${effect.text}`);
    expect(stageWords({ ...altered, effect, live: true }).lead).toBe(preset.meaning);
    // Of the two figures only the right one is measured.
    const both = stageWords({ ...altered, effect, twoReadings: true });
    expect(both.lead).toBe(`${preset.meaning} Right, re-inferred: hands and feet out of step.`);
    expect(stageWords({ ...altered, preset: null, effect }).lead).toMatch(/of your own.*out of step\.$/);
  });
});
