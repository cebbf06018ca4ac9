import { describe, expect, it } from "vitest";
import type { LiveBody } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import { Feet, gaitOf, legsOf } from "./feet";

/** Lands on the left foot at phase 0.2, on the right one at 0.7; a turn takes a second. */
const gait = { part: 0, lands: [0.2, 0.7] as [number, number], pace: 1 };

/** Presses at these times, in seconds; the turns at the end of each of `seconds` seconds. */
function walked(presses: readonly [0 | 1, number][], seconds: number) {
  const feet = new Feet(gait, 0);
  const [phases, asked] = [[] as number[], [] as string[]];
  let phase = 0;
  for (let k = 0; k < 60 * seconds; k++) {
    for (const [foot, time] of presses) if (Math.round(60 * time) === k) asked.push(feet.press(foot, k / 60));
    phase += feet.advance(1 / 60);
    phases.push(phase);
  }
  return { phases, asked, at: (second: number) => phases[Math.round(60 * second) - 1]! };
}

describe("two fingers as the feet", () => {
  it("walk in their own rhythm, and stand while nobody presses", () => {
    const { at, asked } = walked(
      Array.from({ length: 8 }, (_, k): [0 | 1, number] => [(k % 2) as 0 | 1, k]),
      12,
    );
    // A step a second: half of the pace that was learned. The phase is at the landing when the next foot is pressed.
    expect(at(5)).toBeCloseTo(0.2 + 4 * 0.5, 1);
    expect(at(7)).toBeCloseTo(0.2 + 6 * 0.5, 1);
    expect(at(9.5)).toBeCloseTo(0.2 + 7 * 0.5, 6);
    expect(at(12)).toBe(at(9.5));
    expect(new Set(asked)).toEqual(new Set(["step"]));
  });

  it("limp: the step of one foot stays shorter", () => {
    const times = [0, 0.3, 1, 1.3, 2, 2.3, 3, 3.3, 4];
    const { phases } = walked(
      times.map((time, k) => [(k % 2) as 0 | 1, time]),
      4,
    );
    const pace = (from: number, to: number) =>
      (phases[Math.round(60 * to)]! - phases[Math.round(60 * from)]!) / (to - from);
    expect(pace(3.1, 3.3)).toBeGreaterThan(1.4 * pace(3.45, 3.95));
  });

  it("say when a foot hops, and when the steps are faster than twice the learned pace", () => {
    expect(
      walked(
        [
          [0, 0],
          [0, 1],
        ],
        2,
      ).asked,
    ).toEqual(["step", "same"]);
    const run = walked(
      Array.from({ length: 20 }, (_, k): [0 | 1, number] => [(k % 2) as 0 | 1, k / 10]),
      4,
    );
    expect(run.asked.slice(1).every((asked) => asked === "fast")).toBe(true);
    const steps = run.phases.slice(1).map((phase, k) => phase - run.phases[k]!);
    expect(Math.max(...steps)).toBeLessThanOrEqual(2 / 60 + 1e-9);
  });

  it("find when each foot lands in the stored frames of a motion", () => {
    // The root walks to z; its legs swing; the left one, at x > 0, is in front at phase 0.25.
    const nodes = [
      { joint: 0, parent: null, endSite: false },
      ...[1, 2].flatMap((joint) => [
        { joint, parent: 0, endSite: false },
        { joint, parent: joint === 1 ? 1 : 3, endSite: true },
      ]),
    ];
    const frames = 60;
    const positions = new Float32Array(frames * 15);
    for (let t = 0; t < frames; t++) {
      const swing = 0.3 * Math.sin((2 * Math.PI * t) / 30);
      const z = 0.04 * t;
      positions.set([0, 1, z], 15 * t);
      positions.set([0.1, 0.1, z + swing, 0.1, 0, z + swing + 0.1], 15 * t + 3);
      positions.set([-0.1, 0.1, z - swing, -0.1, 0, z - swing + 0.1], 15 * t + 9);
    }
    const motion = { positions, frames, nodes: 5, frameTime: 1 / 30 };
    const track = new LiveTrack(motion, frames);
    track.append(motion);
    const body = { figure: { nodes }, parts: [{ joints: [0, 1, 2] }] } as unknown as LiveBody;
    const trace = (count: number) =>
      Array.from({ length: count }, (_, frame) => ({ frame, phases: [(frame / 30) % 1], distances: [0] }));
    const found = gaitOf(body, track, trace(frames));
    expect(found?.lands[0]).toBeCloseTo(0.25, 1);
    expect(found?.lands[1]).toBeCloseTo(0.75, 1);
    expect(found?.pace).toBeCloseTo(1, 1);
    expect(gaitOf(body, track, trace(20))).toBeNull();
    const apart = { ...body, parts: [{ joints: [0, 1] }, { joints: [2] }] } as unknown as LiveBody;
    expect(legsOf(apart, track), "the feet are in two parts").toBeNull();
  });
});
