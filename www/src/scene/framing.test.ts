import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { Motion } from "../engine/protocol";
import { Follower, Framing } from "./framing";
import { Walk } from "./motion";

const STEP = 1 / 30;
const DEGREES = 180 / Math.PI;

/**
 * Ten seconds of a walk that turns by 17 degrees and whose whole body sways by 8 degrees with each stride of
 * 1.1 s: a root, and one node in front of the body that swings up and down.
 */
function curve(): Motion {
  const positions = new Float32Array(300 * 6);
  let [x, z] = [0, 0];
  for (let frame = 0; frame < 300; frame++) {
    const mean = (17 / DEGREES) * (frame / 300);
    const heading = mean + (8 / DEGREES) * Math.sin((2 * Math.PI * frame * STEP) / 1.1);
    x += 1.2 * STEP * Math.sin(mean);
    z += 1.2 * STEP * Math.cos(mean);
    const up = 1 + 0.2 * Math.cos((2 * Math.PI * frame * STEP) / 1.1);
    positions.set([x, 1, z, x + 0.5 * Math.sin(heading), up, z + 0.5 * Math.cos(heading)], frame * 6);
  }
  return { positions, frames: 300, nodes: 2, frameTime: STEP };
}

function aimed(angle: number): Framing {
  const framing = new Framing(new Vector3());
  framing.aim(angle);
  return framing;
}

/** The angle of the camera to the mean heading in the last 1.1 s, and of each picture to the one before. */
function walk(seconds: number, framing: Framing, visitor = (_second: number) => {}) {
  const motion = curve();
  const way = new Walk(motion);
  framing.start(motion);
  const headings: number[] = [];
  const cameras: number[] = [];
  const angles: number[] = [];
  for (let picture = 0, frame = 0; picture < seconds / STEP; picture++) {
    const pose = way.at(frame);
    framing.follow(pose, STEP);
    visitor(picture * STEP);
    headings.push(Math.atan2(pose[3]! - pose[0]!, pose[5]! - pose[2]!));
    cameras.push(Math.atan2(framing.offset.x, framing.offset.z));
    const stride = headings.slice(-33);
    const mean = Math.atan2(
      stride.reduce((sum, angle) => sum + Math.sin(angle), 0),
      stride.reduce((sum, angle) => sum + Math.cos(angle), 0),
    );
    const apart = cameras.at(-1)! - mean;
    angles.push((apart - 2 * Math.PI * Math.round(apart / (2 * Math.PI))) * DEGREES);
    frame += 1;
    if (frame >= way.loop.end) {
      frame -= way.loop.end;
      way.lap();
    }
  }
  return { angles, headings };
}

describe("the camera", () => {
  it("is at the same side of a walker that has turned half a circle after two minutes", () => {
    const { angles, headings } = walk(120, aimed(0.95));
    expect(Math.abs(headings.at(-1)! - headings[0]!) * DEGREES).toBeGreaterThan(130);
    const late = angles.slice(33);
    expect(Math.max(...late) - Math.min(...late)).toBeLessThan(6);
    expect(late.at(-1)).toBeCloseTo(0.95 * DEGREES, -1);
  });

  it("does not sway with the steps", () => {
    const framing = aimed(1);
    const seen: number[] = [];
    walk(8, framing, (second) => second > 5.8 && seen.push(Math.atan2(framing.offset.x, framing.offset.z)));
    // Two strides, in which the body sways by 16 degrees and the mean heading turns by 3.7.
    expect((Math.max(...seen) - Math.min(...seen)) * DEGREES).toBeLessThan(5);
  });

  it("can be put to a turn, a rise and a distance, in units of its own distance", () => {
    const framing = aimed(1);
    framing.wanted = { middle: 0.9, distance: 5 };
    framing.approach();
    framing.look = [0.3, 0.2, 2];
    expect(framing.look).toEqual([0.3, 0.2, 2].map((number) => expect.closeTo(number, 9)));
    expect(framing.offset.length()).toBeCloseTo(10, 9);
  });

  it("keeps a turn and a zoom of the visitor", () => {
    const framing = aimed(1);
    framing.wanted = { middle: 0.9, distance: 5 };
    framing.approach();
    const turn = (second: number) => {
      if (Math.abs(second - 20) < STEP / 2)
        framing.offset.applyAxisAngle(new Vector3(0, 1, 0), 1).multiplyScalar(0.5);
    };
    const { angles } = walk(60, framing, turn);
    expect(angles.at(-1)! - angles[300]!).toBeCloseTo(DEGREES, -1);
    framing.wanted = { middle: 1.1, distance: 10 };
    framing.approach(0.1);
    expect(framing.offset.length()).toBeGreaterThan(2.5);
    expect(framing.offset.length()).toBeLessThan(5);
    framing.approach();
    expect(framing.offset.length()).toBeCloseTo(5);
    expect(framing.middle).toBe(1.1);
  });
});

describe("the way after a figure", () => {
  it.each([1 / 60, 0.25])("is not behind a constant speed, with pictures of %f s", (seconds) => {
    const follower = new Follower();
    let [figure, camera] = [0, 0];
    for (let now = 0; now < 6; now += seconds) {
      figure += 1.3 * seconds;
      camera += follower.next(figure - camera, 0, seconds)[0];
    }
    expect(Math.abs(figure - camera)).toBeLessThan(0.002);
  });

  it("sways less than the figure", () => {
    const follower = new Follower();
    let [camera, most] = [0, 0];
    for (let now = 0; now < 6; now += 1 / 60) {
      camera += follower.next(Math.sin(2 * Math.PI * 1.8 * now) - camera, 0, 1 / 60)[0];
      if (now > 3) most = Math.max(most, Math.abs(camera));
    }
    expect(most).toBeLessThan(0.8);
  });
});
