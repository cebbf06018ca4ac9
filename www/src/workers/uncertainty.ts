// How sure a model is: moment matching through time, and pictures of planes of its latent spaces. No DOM.
import * as Comlink from "comlink";
import { type Clip, Model } from "vcgpdm";
import type { TrainingClip, ModelInfo, RolloutRequest } from "../engine/protocol";
import type { UncertaintyWorker, KeptPoints, KeptReport } from "../engine/whole-protocol";
import { readClip } from "./clips";
import { meanOf, transfer, using } from "./using";

const infoOf = (model: Model) => model.info() as ModelInfo;

/** Looks at the model with these points. */
function withKept<Found>(
  model: Model,
  { poses, dynamics }: KeptPoints,
  look: (fewer: Model) => Found,
): Found {
  return using(model.withPoints(poses, dynamics), look);
}

function keptBound(model: Model, kept: KeptPoints): number {
  return withKept(model, kept, (fewer) => infoOf(fewer).provenance.bound);
}

function keptReport(model: Model, kept: KeptPoints, request: RolloutRequest): KeptReport {
  return withKept(model, kept, (fewer) => {
    const { figure, frameTime, parts, provenance } = infoOf(fewer);
    return using(fewer.rollout(meanOf(request)), (rollout) => ({
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
    using(current().moments(meanOf(request)), (moments) => {
      const parts = current()
        .info()
        .parts.map((_, part) => ({ means: moments.means(part), covariances: moments.covariances(part) }));
      return transfer(parts, ...parts.flatMap(({ means, covariances }) => [means, covariances]));
    }),
  paintPlane: (request, part, picture) =>
    using(current().rollout(meanOf(request)), (rollout) => {
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
  columnsBvh: (columns, frames) =>
    using(current().fill(columns, { frames }), (rollout) => rollout.toBvh({ plainNames: true })),
  latentLogDensity: (text, request) =>
    using(Model.fromJson(text), (model) =>
      using(model.rollout(meanOf(request)), (rollout) => rollout.latentLogDensity()),
    ),
  keptBounds: (choices) => choices.map((kept) => keptBound(current(), kept)),
  keptRollout: (kept, request) => {
    const report = keptReport(current(), kept, request);
    return transfer(report, report.motion.positions, ...report.latents);
  },
};
