// The numbers of the chapter against the library.
import { expect, it } from "vitest";
import type { PredictionsReport } from "../../engine/protocol";
import { startModel } from "../../engine/start-model.fake";
import { largestDistance } from "../../scene/motion";
import { meansOf, productOf } from "./product-chapter";

const ARMS = 1;
const { model, info } = await startModel();
const learned = info.alpha.map((row) => row[ARMS]!);
const withAlphas = (alphas: readonly number[]) =>
  info.alpha.map((row, source) => row.map((value, target) => (target === ARMS ? alphas[source]! : value)));

/** The predictions in the first predicted frame, whose history no coupling changes. */
function firstPredictions(alphas: readonly number[]): PredictionsReport {
  const request = { frames: 4, sequence: 0, alpha: withAlphas(alphas) };
  const found = model.rollout(request).predictions();
  const parts = info.parts.map((_, target) => ({
    experts: info.parts.map((_, source) => ({
      means: found.expertMeans(source, target),
      variances: found.expertVariances(source, target),
    })),
    product: { means: found.means(target), variances: found.variances(target) },
  }));
  return { revision: 1, request: { ...request, reading: "as-learned" }, firstFrame: found.firstFrame, parts };
}

const dimensions = info.parts[ARMS]!.latent;
const means = meansOf(firstPredictions(learned), ARMS, 0, dimensions);

for (const alphas of [learned, learned.map((alpha) => 2 * alpha), [0.004, 0.9], [30, 0.02]])
  it(`is the library's product under the couplings ${alphas.map((alpha) => alpha.toPrecision(2)).join(" and ")}`, () => {
    const { product } = firstPredictions(alphas).parts[ARMS]!;
    const { mean, variance } = productOf(means, alphas);
    mean.forEach((value, a) => expect(value).toBeCloseTo(product.means[a]!, 9));
    expect(variance).toBeCloseTo(1 / alphas.reduce((sum, alpha) => sum + 1 / alpha, 0), 12);
    // The experts are not sure either, so the library's step is at least as uncertain.
    expect(variance).toBeLessThanOrEqual(product.variances[0]! + 1e-12);
  });

it("finds that doubled couplings move no joint, and that another ratio does", () => {
  const walk = (alphas: readonly number[]) => {
    const rollout = model.rollout({ frames: 300, sequence: 0, alpha: withAlphas(alphas) });
    const positions = rollout.positions();
    return { positions, frames: 300, nodes: info.figure.nodes.length, frameTime: info.frameTime };
  };
  expect(largestDistance(walk(learned), walk(learned.map((alpha) => 2 * alpha)))).toBe(0);
  expect(largestDistance(walk(learned), walk([2 * learned[0]!, learned[1]!]))).toBeGreaterThan(0.01);
});
