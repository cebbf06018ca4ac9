// How sure a model is: moment matching through time, and pictures of planes of its latent spaces. No DOM.
import * as Comlink from "comlink";
import { Model } from "vcgpdm";
import type { UncertaintyWorker } from "../engine/whole-protocol";
import { keptBound, keptReport } from "./kept-points";
import { transfer } from "./transfer";
import { using } from "./using";

let open: Model | null = null;

function current(): Model {
  if (!open) throw new Error("There is no model yet: open one.");
  return open;
}

export const uncertaintyWorker: UncertaintyWorker = {
  openOutlook(text) {
    const model = Model.fromJson(text);
    open?.free();
    open = model;
  },
  moments: (request) =>
    using(current().moments(request), (moments) => {
      const parts = current()
        .info()
        .parts.map((_, part) => ({ means: moments.means(part), covariances: moments.covariances(part) }));
      return transfer(parts, ...parts.flatMap(({ means, covariances }) => [means, covariances]));
    }),
  paintPlane: (request, part, picture) =>
    using(current().rollout(request), (rollout) => {
      const bitmap = rollout.paintPlane(part, picture).transferToImageBitmap();
      return Comlink.transfer(bitmap, [bitmap]);
    }),
  keptBounds: (choices) => choices.map((kept) => keptBound(current(), kept)),
  keptRollout: (kept, request) => {
    const report = keptReport(current(), kept, request);
    return transfer(report, report.motion.positions, ...report.latents);
  },
};
