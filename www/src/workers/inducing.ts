// The inducing points of a model with couplings.
import type { Model } from "vcgpdm/player";
import type { DynamicsInducing, ModelInfo, ModelView } from "../engine/protocol";

export function inducingOf(
  model: Pick<Model, "poseIps" | "dynamicsIps" | "dynamicsIvs">,
  info: ModelInfo,
): Pick<ModelView, "poseInducing" | "dynamicsInducing"> {
  const parts = info.parts.map((_, i) => i);
  const dynamics = (source: number, target: number): DynamicsInducing => ({
    count: info.dynamicsIps[source]?.[target] ?? 0,
    inputs: model.dynamicsIps(source, target),
    outputs: model.dynamicsIvs(source, target),
  });
  return {
    poseInducing: parts.map((part) => model.poseIps(part)),
    dynamicsInducing: parts.map((source) => parts.map((target) => dynamics(source, target))),
  };
}
