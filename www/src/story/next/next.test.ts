import { expect, it } from "vitest";
import { deviationsFrom, scorePin, spreadOf } from "./pin";
import { startModel } from "../../engine/start-model.fake";
import { backFrom } from "./next-chapter";

/** Wide in the first direction, narrow in the second. */
const places: [number, number][] = [
  [-2, 0],
  [2, 0],
  [0, -0.5],
  [0, 0.5],
];

it("measures a distance in standard deviations of its direction", () => {
  const spread = spreadOf(places);
  expect(spread.mean).toEqual([0, 0]);
  expect(deviationsFrom(spread, [2, 0])).toBeCloseTo(2 / Math.sqrt(8 / 3), 12);
  expect(deviationsFrom(spread, [0, 0.5])).toBeCloseTo(deviationsFrom(spread, [2, 0]), 12);
});

it("counts the futures that are further from the mean than the pin", () => {
  expect(scorePin(places, [0, 0])).toEqual({ deviations: 0, beaten: 4, futures: 4 });
  expect(scorePin(places, [3, 0]).beaten).toBe(0);
});

const LEGS = 0;
const FRAME = 11;
const { model, info } = await startModel();
const q = info.parts[LEGS]!.latent;
const request = { frames: FRAME + 1, sequence: 0 };
/** The plane of the first two dimensions. */
const sampled = model.sampledRollouts(request, 400, 1).map((rollout): [number, number] => {
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
  const found = spreadOf(sampled);
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
  expect(scorePin(sampled, mean).beaten).toBeGreaterThan(380);
  expect(scorePin(sampled, [mean[0] + 5, mean[1]]).beaten).toBe(0);
});

it("counts the seconds until a path stays near the loop", () => {
  expect(backFrom(Float64Array.of(2, 0.05, 0.5, 0.09, 0.01), 0.5)).toBe(2);
  expect(backFrom(Float64Array.of(0.01, 0.02), 0.5)).toBe(0.5);
});

it("says so when a path does not come back", () => {
  expect(backFrom(Float64Array.of(0.01, 3), 0.5)).toBeNull();
  expect(backFrom(Float64Array.of(0.01, Number.NaN), 0.5)).toBeNull();
  expect(backFrom(new Float64Array(0), 0.5)).toBeNull();
});
