import { describe, expect, it } from "vitest";
import { chain, distances, FADE, findLoop, HERE, placeOnto, poseAt, Walk } from "./motion";
import type { Motion } from "../engine/protocol";

/** Three nodes that swing with a period of 30 frames while the body turns and moves. */
function swinging(frames: number): Motion {
  const positions = new Float32Array(frames * 9);
  for (let t = 0; t < frames; t++) {
    const phase = (2 * Math.PI * t) / 30;
    const yaw = 0.01 * t;
    const body = [0, 1, 0, 0.3, 1.2, 0.2 * Math.sin(phase), -0.2, 0.1, 0.3 * Math.cos(phase)];
    for (let i = 0; i < 9; i += 3) {
      positions[t * 9 + i] = Math.cos(yaw) * body[i]! + Math.sin(yaw) * body[i + 2]! + 0.02 * t;
      positions[t * 9 + i + 1] = body[i + 1]!;
      positions[t * 9 + i + 2] = Math.cos(yaw) * body[i + 2]! - Math.sin(yaw) * body[i]!;
    }
  }
  return { positions, frames, nodes: 3, frameTime: 1 / 30 };
}

const pose = (motion: Motion, frame: number, placement = HERE) =>
  poseAt(motion, frame, placement, new Float32Array(9));
const apart = (a: Float32Array, b: Float32Array) => Math.max(...a.map((value, i) => Math.abs(value - b[i]!)));

describe("placing a pose", () => {
  it("finds the turn and the shift between two copies of a pose", () => {
    const motion = swinging(60);
    const placement = { yaw: 0.8, x: 2, z: -3 };
    const found = placeOnto(pose(motion, 7), pose(motion, 7, placement));
    expect(found.yaw).toBeCloseTo(0.8, 5);
    expect(found.x).toBeCloseTo(2, 5);
    expect(found.z).toBeCloseTo(-3, 5);
  });

  it("chains in order", () => {
    const motion = swinging(60);
    const [a, b] = [
      { yaw: 0.5, x: 1, z: 2 },
      { yaw: -1.2, x: 0.3, z: 0 },
    ];
    const once: Motion = { ...motion, frames: 1, positions: pose(motion, 4, a) };
    expect(apart(pose(once, 0, b), pose(motion, 4, chain(a, b)))).toBeLessThan(1e-5);
  });
});

describe("looping", () => {
  it("loops after whole periods", () => {
    // With three nodes, a small part of the swing can look like a turn: two frames of tolerance.
    const off = ((findLoop(swinging(200)).end + 15) % 30) - 15;
    expect(Math.abs(off)).toBeLessThanOrEqual(2);
  });

  it("ends early enough for the frames that fade into the next lap", () => {
    // The pose of frame 0 comes again at frame 180, but only five frames are left after it.
    const slow = { ...swinging(186), frameTime: 0.1 };
    expect(findLoop(slow).end).toBeLessThanOrEqual(185 - FADE);
  });

  it("has no jump from one lap to the next", () => {
    const walk = new Walk(swinging(200));
    const end = walk.at(walk.loop.end).slice();
    walk.lap();
    expect(apart(walk.at(0), end)).toBeLessThan(1e-4);
    const step = apart(walk.at(3).slice(), walk.at(4));
    expect(step).toBeLessThan(0.15);
  });

  it("plays all frames of a recording", () => {
    const walk = new Walk(swinging(100), true);
    expect(walk.loop.end).toBe(99);
    const end = walk.at(99).slice();
    walk.lap();
    expect(apart(walk.at(0), end)).toBeLessThan(1e-4);
  });

  it("accepts a single frame", () => {
    const walk = new Walk(swinging(1));
    walk.lap();
    expect([...walk.at(0)].every(Number.isFinite)).toBe(true);
  });

  it("stays in place when another motion replaces it", () => {
    const [first, second] = [new Walk(swinging(200)), new Walk(swinging(90))];
    first.lap();
    const now = first.at(40).slice();
    second.alignWith(40, now);
    expect(apart(second.at(40), now)).toBeLessThan(1e-4);
  });
});

describe("the distance of two motions", () => {
  it("is the distance of their poses, in any place and direction", () => {
    const motion = swinging(20);
    const elsewhere = { ...motion, positions: new Float32Array(motion.positions.length) };
    for (let t = 0; t < 20; t++)
      elsewhere.positions.set(pose(motion, t, { yaw: 0.1 * t, x: t, z: -2 }), 9 * t);
    expect(Math.max(...distances(motion, elsewhere))).toBeLessThan(1e-5);
  });

  it("is the mean over the nodes, for the frames of both", () => {
    const motion = swinging(20);
    const raised = { ...motion, frames: 10, positions: motion.positions.slice(0, 90) };
    // One of three nodes 0.3 m higher, in all frames.
    for (let t = 0; t < 10; t++) raised.positions[9 * t + 4]! += 0.3;
    const found = distances(motion, raised);
    expect(found).toHaveLength(10);
    for (const metres of found) expect(metres).toBeCloseTo(0.1, 5);
  });
});
