import { describe, expect, it } from "vitest";
import type { BodyReport, Health } from "../engine/protocol";
import { measuresText } from "./measures-text";

type Limbs = BodyReport["measures"]["parts"][number];

const MOVES_ON: Health = { state: "moves-on", from: null, part: null, rank: 2 };
const NAMES = ["lower", "upper"];

function report(parts: Partial<Limbs>[], health = MOVES_ON, walkingSpeed = 1.5): BodyReport {
  const limbs = parts.map((limb): Limbs => ({ swing: 0.2, period: 1, locking: 1, ...limb }));
  const measures = { limbs: [], parts: limbs, jointSpeed: 1, walkingSpeed, footSlide: null };
  return {
    measures,
    health,
    revision: 1,
    request: { frames: 600, sequence: 0, alpha: null, reading: "as-learned" },
  };
}
const learned = report([{}, {}]);
const textOf = (now: BodyReport) => measuresText(now, learned, NAMES);

describe("the text about measures", () => {
  it("gives the swing as a multiple of the learned one, and says once whether all parts are in step", () => {
    expect(textOf(learned)).toEqual({
      parts: [
        { part: 0, words: "swings 1.00 × as far" },
        { part: 1, words: "swings 1.00 × as far" },
      ],
      step: "hands and feet in step",
      trouble: "",
    });
  });

  it("names the part whose period has changed, and says that hands and feet are out of step", () => {
    const { parts, step } = textOf(report([{ locking: 0.1 }, { swing: 0.16, period: 1.3, locking: 0.1 }]));
    expect(parts[1]?.words).toBe("swings 0.80 × as far, slower (1.30 s, not 1.00 s)");
    expect([parts[0]?.words, step]).toEqual(["swings 1.00 × as far", "hands and feet out of step"]);
  });

  it("says for each part whether it is in step, where the parts differ", () => {
    const { parts, step } = textOf(report([{ locking: 0.95 }, { locking: 0.7 }]));
    expect(parts.map(({ words }) => words.split(", ").at(-1))).toEqual(["in step", "partly in step"]);
    expect(step).toBe("");
  });

  it("leaves out parts without hands and feet, and mentions no step where nothing swings", () => {
    const { parts, step } = textOf(report([{ swing: null }, { swing: 0.002, period: null, locking: null }]));
    expect(parts).toEqual([{ part: 1, words: "hardly swings, 0.01 × as far" }]);
    expect(textOf(report([{ locking: null }, { locking: null }])).step).toBe("");
    expect(step).toBe("hands and feet in step");
  });

  it("gives centimetres where nothing swung as learned", () => {
    const still = report([{ swing: 0.001 }, {}]);
    expect(measuresText(report([{}, {}]), still, NAMES).parts[0]?.words).toBe("swings 20 cm");
  });

  it("gives the ratio of the walking speeds where it is not 1", () => {
    expect(textOf(report([{}, {}], MOVES_ON, 1.05)).step).toBe(
      "hands and feet in step; walks 0.70 × as fast",
    );
  });

  it("says how a motion ends that does not move on", () => {
    const still = textOf(
      report([{ swing: 0 }, {}], { state: "stands-still", from: 0.71, part: null, rank: 1 }),
    );
    expect(still).toEqual({ parts: [], step: "", trouble: "stands still from 0.7 s on" });
    const away = textOf(report([{}, {}], { state: "leaves-training-range", from: 3, part: 1, rank: 1 }));
    expect(away.trouble).toBe("upper leaves the training range from 3.0 s on");
    expect(away.parts).toHaveLength(2);
    expect(
      textOf(report([{}, {}], { state: "not-finite", from: null, part: null, rank: 0 })).trouble,
    ).toMatch(/runs away/);
  });
});
