// A model with some of its inducing points only: its bound and its motion. No DOM.
import type { Model } from "vcgpdm";
import type { ModelInfo, RolloutRequest } from "../engine/protocol";
import type { KeptPoints, KeptReport } from "../engine/whole-protocol";
import { using } from "./using";

const infoOf = (model: Model) => model.info() as ModelInfo;

/** Looks at the model with these points. */
function withKept<Found>(
  model: Model,
  { poses, dynamics }: KeptPoints,
  look: (fewer: Model) => Found,
): Found {
  return using(model.withPoints(poses, dynamics), look);
}

export function keptBound(model: Model, kept: KeptPoints): number {
  return withKept(model, kept, (fewer) => infoOf(fewer).provenance.bound);
}

export function keptReport(model: Model, kept: KeptPoints, request: RolloutRequest): KeptReport {
  return withKept(model, kept, (fewer) => {
    const { figure, frameTime, parts, provenance } = infoOf(fewer);
    return using(fewer.rollout(request), (rollout) => ({
      bound: provenance.bound,
      motion: {
        positions: rollout.positions(),
        frames: rollout.frames,
        nodes: figure.nodes.length,
        frameTime,
      },
      latents: parts.map((_, part) => rollout.latents(part)),
      measures: rollout.measures(Math.floor(request.frames / 3)),
      health: rollout.health(),
    }));
  });
}
