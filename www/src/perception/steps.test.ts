import { describe, expect, it } from "vitest";
import { paragraphsOf, type Step, stepsOf } from "./steps";
import { study, trialsOf } from "./study.fake";

const words = (steps: readonly Step[]) =>
  steps.map((step) => (step.kind === "pair" ? step.position : step.page)).join(" ");

describe("the steps of a participant", () => {
  it("begin with consent and instructions, pause between blocks, and end with thanks", () => {
    expect(words(stepsOf(study, trialsOf([2, 2]), 0))).toBe("consent instructions 0 1 pause 2 3 end");
  });

  it("continue where they stopped, with the instructions but without another pause", () => {
    expect(words(stepsOf(study, trialsOf([2, 2]), 1))).toBe("instructions 1 pause 2 3 end");
    expect(words(stepsOf(study, trialsOf([2, 2]), 2))).toBe("instructions 2 3 end");
    expect(words(stepsOf(study, trialsOf([2, 2]), 4))).toBe("instructions end");
  });

  it("make a pause as long as the study says", () => {
    const pauses = stepsOf({ ...study, pauseSeconds: 30 }, trialsOf([1, 1]), 0).filter(
      (step) => step.kind === "text" && step.page === "pause",
    );
    expect(pauses).toMatchObject([{ wait: 30 }]);
  });
});

it("empty lines separate paragraphs", () => {
  expect(paragraphsOf("One\nline.\n\n \nTwo.\n")).toEqual(["One\nline.", "Two."]);
  expect(paragraphsOf("")).toEqual([]);
});
