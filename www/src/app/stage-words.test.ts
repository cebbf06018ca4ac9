import { describe, expect, it } from "vitest";
import { type OnStage, stageWords } from "./stage-words";

const walking: OnStage = {
  kind: "model",
  clip: null,
  learnedFrom: ["35_01.bvh", "35_02.bvh", "35_03.bvh"],
  point: null,
  altered: false,
  preset: null,
  live: false,
  twoReadings: false,
  learning: null,
};

describe("the words about the stage", () => {
  it("say of a model's motion who made it, and how many clips it was learned from", () => {
    expect(stageWords(walking)).toEqual({ title: "Made by the model", text: "learned from 3 clips" });
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
      expect(JSON.stringify(words)).not.toMatch(/by the model|outline/);
      expect([words.title, words.text]).toEqual(["walk 1", expect.stringMatching(/^A clip.*not the model$/)]);
    }
  });

  it("say of the stored first seconds no number of clips that is not known yet", () => {
    expect(stageWords({ ...walking, kind: "first", learnedFrom: null }).text).toBe("");
  });

  it("follow a training, changed couplings and an inducing point", () => {
    const learning = stageWords({ ...walking, learning: { iteration: 12, seed: 7 } });
    expect(learning.text).toBe("Iteration 12, seed 7");
    expect(stageWords({ ...walking, altered: true }).title).toBe("Couplings changed");
    expect(stageWords({ ...walking, altered: true, twoReadings: true }).text).not.toMatch(/outline/);
    expect(stageWords({ ...walking, altered: true, live: true }).text).not.toMatch(/outline/);
    expect(stageWords({ ...walking, twoReadings: true }).text).toMatch(/change a coupling/);
    expect(stageWords({ ...walking, altered: true, point: "A pose of lower" }).text).toBe("A pose of lower");
  });

  it("name the preset of changed couplings", () => {
    const altered = { ...walking, altered: true, preset: { name: "Let the arms go" } };
    expect(stageWords(altered).title).toBe("Let the arms go");
  });
});
