import { describe, expect, it } from "vitest";
import type { StudyInfo } from "../engine/whole-protocol";
import { confusionOf, simulatedAnswer } from "./simulated";
import { study, trialsOf } from "./study.fake";

const [natural, generated] = study.stimuli as [StudyInfo["stimuli"][0], StudyInfo["stimuli"][0]];
const withErrors = (...errors: number[]) => ({
  ...study,
  stimuli: [natural, ...errors.map((mse) => ({ ...generated, scores: { ...generated.scores!, mse } }))],
});

describe("a simulated participant", () => {
  it("takes models with smaller errors for natural more often, at most half the time", () => {
    const [, small = 0, middle = 0, large = 0] = confusionOf(withErrors(0.001, 0.01, 0.1));
    expect(middle).toBeCloseTo(0.25);
    expect(small).toBeGreaterThan(middle);
    expect(large).toBeLessThan(middle);
    expect(small).toBeLessThan(0.5);
    expect(confusionOf(study)[1]).toBeCloseTo(0.25);
  });

  it("answers with that probability, and passes every attention check", () => {
    const [onLeft, onRight] = trialsOf([2]);
    expect(simulatedAnswer(onLeft!, [0, 0.3], 0.29)).toBe("right");
    expect(simulatedAnswer(onLeft!, [0, 0.3], 0.31)).toBe("left");
    expect(simulatedAnswer(onRight!, [0, 0.3], 0.31)).toBe("right");
    expect(simulatedAnswer({ ...onLeft!, kind: "attention" }, [0, 1], 0)).toBe("left");
    expect(simulatedAnswer({ ...onLeft!, naturalSide: "none" }, [0, 1], 0.7)).toBe("right");
  });
});
