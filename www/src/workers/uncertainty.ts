// How sure a model is: moment matching through time, and pictures of planes of its latent spaces. No DOM.
import * as Comlink from "comlink";
import { type Clip, Model } from "vcgpdm";
import type { TrainingClip } from "../engine/protocol";
import type { UncertaintyWorker } from "../engine/whole-protocol";
import { readClip } from "./clips";
import { keptBound, keptReport } from "./kept-points";
import { transfer } from "./transfer";
import { using } from "./using";

let open: Model | null = null;

function current(): Model {
  if (!open) throw new Error("There is no model yet: open one.");
  return open;
}

/** The chosen frames of a clip; the caller frees them. */
async function pieceOf({ source, first, end }: TrainingClip): Promise<Clip> {
  return using(await readClip(source), (clip) => clip.cut(first, end));
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
  async complete({ clip, given, until, alpha, reading }) {
    const model = current();
    const options = { given: [given], ...(until === null ? {} : { until }), alpha, reading };
    return using(await pieceOf(clip), (piece) =>
      using(model.complete(piece, options), (found) => {
        const { frames } = found;
        const { figure, frameTime, parts } = model.info();
        const shape = { frames, nodes: figure?.nodes.length ?? 0, frameTime };
        const motion = { ...shape, positions: found.positions() };
        const recorded = { ...shape, positions: found.recorded() };
        const latents = found.latents(parts.findIndex(({ name }) => name === given));
        const answer = { motion, recorded, latents, scores: found.scores() };
        return transfer(answer, motion.positions, recorded.positions, latents);
      }),
    );
  },
  inferStart: async (text, clip, frames) =>
    using(await pieceOf(clip), (piece) => using(Model.fromJson(text), (model) => model.infer(piece, frames))),
  predictedNaturalness: (text, request) =>
    using(Model.fromJson(text), (model) =>
      using(model.rollout(request), (rollout) => rollout.predictedNaturalness()),
    ),
  keptBounds: (choices) => choices.map((kept) => keptBound(current(), kept)),
  keptRollout: (kept, request) => {
    const report = keptReport(current(), kept, request);
    return transfer(report, report.motion.positions, ...report.latents);
  },
};
