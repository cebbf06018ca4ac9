// The choices of inducing points against the library.
import { expect, it } from "vitest";
import { lapOf } from "../latent/drawing";
import { startModel } from "../../engine/start-model.fake";
import { allPoints, bestChoice, choices, count, keptOf, LEGS, type LegPoints } from "./elimination";
import { stumbles, walkError } from "./walk-error";

const FRAMES = 240;
const { model, info } = await startModel();
const learned = model.rollout({ frames: FRAMES, sequence: 0 });
const nodes = info.figure.nodes.length;
const motionOf = (positions: Float32Array) => ({
  positions,
  frames: FRAMES,
  nodes,
  frameTime: info.frameTime,
});
const walk = motionOf(learned.positions());
const lap = lapOf(learned.latents(LEGS), info.parts[LEGS]!.latent);

const fewer = (points: LegPoints) => {
  const { poses, dynamics } = keptOf(info, points);
  return model.withPoints(poses, dynamics);
};
const boundOf = (points: LegPoints): number => fewer(points).info().provenance.bound;

function trial(points: LegPoints) {
  const rollout = fewer(points).rollout({ frames: FRAMES, sequence: 0 });
  const error = walkError(motionOf(rollout.positions()), walk, lap);
  const [measures, health] = [rollout.measures(80), rollout.health()];
  return { error, stumbles: stumbles({ measures, health, error }, learned.measures(80), LEGS) };
}

it("with all points it is the model itself", () => {
  expect(boundOf(allPoints(info))).toBe(info.provenance.bound);
  const { error, stumbles } = trial(allPoints(info));
  expect(error).toBeLessThan(0.005);
  expect(stumbles).toBe(false);
});

// The reply to the guess, and the notes for teachers, say so.
it("loses bound with each point, walks with half of them, stumbles with one less, and walks with six others", () => {
  let points = allPoints(info);
  let before = boundOf(points);
  const half = count(points) / 2;
  while (count(points) > half) {
    const all = choices(points);
    const bounds = all.map(boundOf);
    points = bestChoice(all, bounds);
    expect(Math.max(...bounds)).toBeLessThan(before);
    before = Math.max(...bounds);
  }
  expect(trial(points).stumbles).toBe(false);
  const less = choices(points);
  expect(trial(bestChoice(less, less.map(boundOf))).stumbles).toBe(true);
  expect(trial({ poses: [8, 10], steps: [3, 6, 7, 9] }).stumbles).toBe(false);
});
