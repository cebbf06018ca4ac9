import { expect, it } from "vitest";
import type { Health, Measures, Motion } from "../../engine/protocol";
import { stumbles, walkError } from "./walk-error";

/** Hips, right hip, left hip and a foot that goes up and down; the body walks on and turns. */
function walk(frames: number, { turn = 0, lift = 0.2 } = {}): Motion {
  const positions = new Float32Array(12 * frames);
  for (let t = 0; t < frames; t++) {
    const angle = turn * t;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const nodes = [
      [0, 1, 0],
      [-0.1, 0.9, 0],
      [0.1, 0.9, 0],
      [0.1, lift * Math.sin(t), 0.3],
    ];
    nodes.forEach(([x, y, z], node) =>
      positions.set([t + c * x! - s * z!, y!, s * x! + c * z!], 12 * t + 3 * node),
    );
  }
  return { positions, frames, nodes: 4, frameTime: 0.1 };
}

const lap = { first: 0, frames: 40 };

it("is zero for the walk itself, at another place and in another direction", () => {
  expect(walkError(walk(40, { turn: 0.1 }), walk(40), lap)).toBeCloseTo(0, 5);
});

it("is the mean distance of the joints from the nearest pose", () => {
  expect(walkError(walk(40, { lift: 0.6 }), walk(40), lap)).toBeGreaterThan(0.02);
});

const health: Health = { state: "moves-on", from: null, part: null, rank: 3, pace: null, parts: [] };
const swings = (swing: number, period: number | null) =>
  ({ parts: [{ swing, period, locking: 1 }] }) as unknown as Measures;

it("calls a motion a stumble that stops, swings less, keeps another pace or has other poses", () => {
  const full = swings(0.3, 1);
  const fine = { health, measures: swings(0.29, 1.05), error: 0.01 };
  expect(stumbles(fine, full, 0)).toBe(false);
  expect(stumbles({ ...fine, health: { ...health, state: "stands-still" } }, full, 0)).toBe(true);
  expect(stumbles({ ...fine, measures: swings(0.1, 1) }, full, 0)).toBe(true);
  expect(stumbles({ ...fine, measures: swings(0.3, 1.4) }, full, 0)).toBe(true);
  expect(stumbles({ ...fine, measures: swings(0.3, null) }, full, 0)).toBe(true);
  expect(stumbles({ ...fine, error: 0.2 }, full, 0)).toBe(true);
  expect(stumbles({ ...fine, error: Number.NaN }, full, 0)).toBe(true);
});
