import { expect, it } from "vitest";
import model from "../../first/model.json";
import { kernelsOf } from "./numbers-view";

it("finds lengthscales, variances and couplings of the model that comes with the page", () => {
  const { order, poses, experts } = kernelsOf(JSON.stringify(model));
  expect(order).toBe(2);
  expect(poses.map(({ part }) => part)).toEqual(["lower", "upper"]);
  expect(poses[0]).toMatchObject({ variance: model.parts[0]?.variance, noise: model.parts[0]?.beta });
  expect(poses[0]?.lengthscales[0]).toBeCloseTo(Math.sqrt(model.parts[0]?.lambda[0] ?? 0), 12);
  expect(experts.map(({ source, target, coupling }) => [source, target, coupling])).toEqual([
    [0, 0, model.alpha[0]?.[0]],
    [1, 0, model.alpha[1]?.[0]],
    [0, 1, model.alpha[0]?.[1]],
    [1, 1, model.alpha[1]?.[1]],
  ]);
  // Two frames of three latent dimensions.
  for (const { lengthscales } of experts) expect(lengthscales).toHaveLength(6);
});
