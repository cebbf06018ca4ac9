// The kernel and the variance of the chapter against the library.
import { expect, it } from "vitest";
import { startModel } from "../../engine/start-model.fake";
import { kernel } from "./process";

it("has the kernel of the library", async () => {
  const { model, info, text } = await startModel();
  const [legs] = (JSON.parse(text) as { parts: { lambda: number[] }[] }).parts;
  const q = info.parts[0]!.latent;
  const point = model.poseIps(0).slice(0, q);
  const moved = point.slice();
  moved[1]! += 2.5;
  const [weight] = model.poseIpWeights(0, 0, moved);
  expect(kernel({ lambda: legs!.lambda[1]!, variance: 1 }, point[1]!, moved[1]!)).toBeCloseTo(weight!, 12);
});
