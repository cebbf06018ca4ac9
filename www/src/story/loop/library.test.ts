// The poses and the doubt of the chapter against the library.
import { expect, it } from "vitest";
import { principalAxes } from "../../latents/projection";
import { distances } from "../../scene/motion";
import { lapOf, lift, projectPath } from "../latent/drawing";
import { startModel } from "../../engine/start-model.fake";
import { columnsOf } from "./loop-chapter";

const LEGS = 0;
const { model, info } = await startModel();
const rollout = model.rollout({ frames: 300, sequence: 0 });
const q = info.parts[LEGS]!.latent;
const lap = lapOf(rollout.latents(LEGS), q);

it("finds the lap that the library measures as the period of the feet", () => {
  const { period } = rollout.measures(100).parts[LEGS]!;
  expect(lap.frames * info.frameTime).toBeCloseTo(period!, 1);
});

it("counts each column of the model in one part", () => {
  const counts = info.parts.map(({ joints }) => columnsOf(info.columns, info.joints, joints));
  expect(counts.every((count) => count > 30)).toBe(true);
  expect(counts.reduce((sum, count) => sum + count)).toBe(info.columns.length);
});

it("shows the pose of the walk on the loop", () => {
  const frame = lap.first + 7;
  const latents = info.parts.flatMap(({ latent }, part) => [
    ...rollout.latents(part).slice(frame * latent, (frame + 1) * latent),
  ]);
  const nodes = info.figure.nodes.length;
  const still = (positions: Float32Array) => ({ positions, frames: 1, nodes, frameTime: 1 });
  const walked = rollout.positions().slice(3 * nodes * frame, 3 * nodes * (frame + 1));
  const [apart] = distances(still(model.bodyPose(Float64Array.from(latents))), still(walked));
  expect(apart).toBeLessThan(1e-4);
});

it("has the doubt of the library's picture of the plane, small on the loop and large far away", () => {
  const projection = principalAxes(lap.path, q);
  const seen = projectPath(projection, lap.path);
  const points = [1, 2, 4].map((factor) => lift(projection, seen, factor * seen[0]!, factor * seen[1]!));
  const shares = model.poseVariance(LEGS, Float64Array.from(points.flatMap((point) => [...point])));
  const field = rollout.latentField(
    LEGS,
    points.map((point) => [...point]),
  );
  shares.forEach((share, n) => expect(share).toBeCloseTo(field.poseVariance[n]!, 9));
  expect(shares[0]).toBeLessThan(0.01);
  expect(shares[1]).toBeGreaterThan(shares[0]!);
  expect(shares[2]).toBeGreaterThan(0.2);
});
