// The spread of the futures against the moments that the library computes without sampling.
import { expect, it } from "vitest";
import { startModel } from "../../engine/start-model.fake";
import { deviationsFrom, scorePin, spreadOf } from "./pin";

const LEGS = 0;
const FRAME = 11;
const { model, info } = await startModel();
const q = info.parts[LEGS]!.latent;
const request = { frames: FRAME + 1, sequence: 0 };
/** The plane of the first two dimensions. */
const places = model.sampledRollouts(request, 400, 1).map((rollout): [number, number] => {
  const path = rollout.latents(LEGS);
  return [path[FRAME * q]!, path[FRAME * q + 1]!];
});
const moments = model.moments(request);
const means = moments.means(LEGS);
const covariances = moments.covariances(LEGS);
const mean: [number, number] = [means[FRAME * q]!, means[FRAME * q + 1]!];
const covariance = (a: number, b: number) => covariances[(FRAME * q + a) * q + b]!;
const expected = {
  mean,
  covariance: [covariance(0, 0), covariance(0, 1), covariance(1, 1)] as [number, number, number],
};

it("measures a pin as the Gaussian of moment matching does", () => {
  const found = spreadOf(places);
  expect(deviationsFrom(expected, found.mean)).toBeLessThan(0.2);
  for (const [right, up] of [
    [1, 0],
    [0, 1],
    [1, 1],
    [-1, 1],
  ] as const) {
    const pin: [number, number] = [mean[0] + right, mean[1] + up];
    const ratio = deviationsFrom(found, pin) / deviationsFrom(expected, pin);
    expect(ratio).toBeGreaterThan(0.8);
    expect(ratio).toBeLessThan(1.25);
  }
});

it("says that the mean beats nearly all futures, and a place far away none", () => {
  expect(scorePin(places, mean).beaten).toBeGreaterThan(380);
  expect(scorePin(places, [mean[0] + 5, mean[1]]).beaten).toBe(0);
});
