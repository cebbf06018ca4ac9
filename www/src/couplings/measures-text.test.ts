import { describe, expect, it } from "vitest";
import type { BodyReport, Health } from "../engine/protocol";
import { measuresText } from "./measures-text";

type Limbs = BodyReport["measures"]["parts"][number];

const MOVES_ON: Health = { state: "moves-on", from: null, part: null, rank: 3, pace: null, parts: [] };
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
        { part: 0, words: "1.00 × as far", changed: false },
        { part: 1, words: "1.00 × as far", changed: false },
      ],
      step: "hands and feet in step",
      trouble: "",
    });
  });

  it("names the part whose period has changed, and says that hands and feet are out of step", () => {
    const { parts, step } = textOf(report([{ locking: 0.1 }, { swing: 0.16, period: 1.3, locking: 0.1 }]));
    expect(parts[1]?.words).toBe("0.80 × as far, 1.30 s instead of 1.00 s");
    expect([parts[0]?.words, step]).toEqual(["1.00 × as far", "hands and feet out of step"]);
  });

  it("says for each part whether it is in step, where the parts differ", () => {
    const { parts, step } = textOf(report([{ locking: 0.95 }, { locking: 0.7 }]));
    expect(parts.map(({ words }) => words.split(", ").at(-1))).toEqual(["in step", "partly in step"]);
    expect(step).toBe("");
  });

  it("leaves out parts without hands and feet, and mentions no step where nothing swings", () => {
    const { parts, step } = textOf(report([{ swing: null }, { swing: 0.002, period: null, locking: null }]));
    expect(parts).toEqual([{ part: 1, words: "hardly any swing, 0.01 × as far", changed: true }]);
    expect(textOf(report([{ locking: null }, { locking: null }])).step).toBe("");
    expect(step).toBe("hands and feet in step");
  });

  it("gives centimetres where nothing swung as learned", () => {
    const still = report([{ swing: 0.001 }, {}]);
    expect(measuresText(report([{}, {}]), still, NAMES).parts[0]?.words).toBe("20 cm far");
  });

  it("gives the ratio of the walking speeds where it is not 1", () => {
    expect(textOf(report([{}, {}], MOVES_ON, 1.05)).step).toBe("hands and feet in step; 0.70 × as fast");
  });

  it("says how a motion ends that does not move on", () => {
    const still = textOf(
      report([{ swing: 0 }, {}], {
        state: "stands-still",
        from: 0.71,
        part: null,
        rank: 1,
        pace: null,
        parts: [],
      }),
    );
    expect(still).toEqual({ parts: [], step: "", trouble: "stands still from 0.7 s on" });
    const away = textOf(
      report([{}, {}], { state: "leaves-training-range", from: 3, part: 1, rank: 1, pace: null, parts: [] }),
    );
    expect(away.trouble).toBe("outside the training range from 3.0 s on: upper");
    expect(away.parts).toHaveLength(2);
    expect(
      textOf(
        report([{}, {}], { state: "not-finite", from: null, part: null, rank: 0, pace: null, parts: [] }),
      ).trouble,
    ).toMatch(/runs away/);
  });
});

const CALM: NonNullable<Health["pace"]> = {
  speed: 1,
  clipSpeed: 1,
  times: 1,
  turnsBack: 0,
  clipTurnsBack: 0,
};

const inPose = (stillFrom: (number | null)[], health: Partial<Health> = {}): Health => ({
  ...MOVES_ON,
  ...health,
  parts: stillFrom.map((seconds) => ({ visited: 1, stillFrom: seconds, pace: CALM })),
});

it("gives the lost step to the part that moves in another way, not to the limb that it swings with", () => {
  // The left hand (part 0) no longer hears the legs. The right foot (part 1) swings with it, and as before.
  const five = report([{ swing: 0.17, period: 1.4, locking: 0.2 }, { locking: 0.2 }, {}]);
  const { parts } = measuresText(five, report([{}, {}, {}]), ["left arm", "right leg", "right arm"]);
  expect(parts.map(({ words }) => words)).toEqual([
    "0.85 × as far, 1.40 s instead of 1.00 s, out of step",
    "1.00 × as far",
    "1.00 × as far, in step",
  ]);
});

it("says that a swing lost its pace, not that it has a long period", () => {
  const { parts } = textOf(report([{}, { swing: 0.17, period: null, locking: null }]));
  expect(parts[1]?.words).toBe("0.85 × as far, without a steady pace");
});

it("says that arms keep one pose, from when on", () => {
  const { parts } = textOf(report([{}, { swing: 0.002, period: null, locking: null }], inPose([null, 0.9])));
  expect(parts.map(({ words }) => words)).toEqual(["1.00 × as far", "one pose from 0.9 s on"]);
});

it("says that a figure which glides on keeps one pose, and does not say that it stands still", () => {
  const glides = report(
    [{ swing: 0 }, { swing: 0 }],
    inPose([0.7, 0.7], { state: "keeps-one-pose", from: 0.7 }),
    1.2,
  );
  expect(textOf(glides)).toEqual({ parts: [], step: "", trouble: "keeps one pose from 0.7 s on" });
});

it("says which share of its clips’ poses a part visits, if it is small", () => {
  const hops: Health = {
    ...MOVES_ON,
    state: "visits-few-poses",
    part: 0,
    parts: [{ visited: 0.221, stillFrom: null, pace: CALM }],
  };
  expect(textOf(report([{}, {}], hops)).trouble).toBe("visits 22 % of its clips’ poses in lower");
});

it("says how fast a part shakes, and how many of its steps turn back", () => {
  const pace = { ...CALM, times: 7, turnsBack: 0.958 };
  const part = { visited: 1, stillFrom: null, pace };
  const shakes: Health = { ...MOVES_ON, state: "shakes", part: 1, parts: [{ ...part, pace: CALM }, part] };
  expect(textOf(report([{}, {}], shakes)).trouble).toBe(
    "shakes (upper): 7.0 × as fast as in its clips, and 96 % of its steps turn back",
  );
  const body = textOf(report([{}, {}], { ...shakes, part: null, pace })).trouble;
  expect(body).toMatch(/^shakes \(the whole body\): 7\.0/);
});
