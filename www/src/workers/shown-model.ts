// The model that the page shows: its rollouts and inducing points. No DOM.
import { Model, type Rollout } from "vcgpdm/player";
import { MAX_PARTS } from "../engine/limits";
import type {
  BodyReport,
  InducingPoint,
  InducingReport,
  ModelInfo,
  ModelView,
  OpenedModel,
  Predictions,
  PredictionsReport,
  RolloutRequest,
  RolloutResult,
} from "../engine/protocol";
import { inducingOf } from "./inducing";
import { meanOf, transfer, using } from "./using";

/** The open model, with its description. */
interface OpenModel {
  model: Model;
  info: ModelInfo;
  /** Grows with every model. */
  revision: number;
}

export class ShownModel {
  #open: OpenModel | null = null;
  /** The last rollout for which weights of an inducing point were computed. */
  #pointedRollout: RolloutResult | null = null;

  /** Opens a model and rolls it out as learned. If that fails, the earlier model stays open. */
  open(text: string, frames: number, revision: number): OpenedModel {
    const model = Model.fromJson(text);
    try {
      const info = model.info() as ModelInfo;
      const parts = info.parts.length;
      if (parts > MAX_PARTS)
        throw new Error(
          `expected a model of ${MAX_PARTS} parts at most, found ${parts}: the page has no space for their couplings. The terminal program rolls it out`,
        );
      const next = { model, info, revision };
      const rollout = roll(next, { frames, sequence: 0, alpha: null, reading: "as-learned" });
      const opened = { model: view(next), rollout };
      this.#open?.model.free();
      this.#open = next;
      return opened;
    } catch (problem) {
      model.free();
      throw problem;
    }
  }

  rollout(request: RolloutRequest): RolloutResult {
    const result = roll(this.#current(), request);
    return transfer(result, result.motion.positions, ...result.latents);
  }

  rolloutBvh(request: RolloutRequest): string {
    return this.withRollout(request, (rollout) => rollout.toBvh({ plainNames: true }));
  }

  bodyReport(request: RolloutRequest, first: number): BodyReport {
    const { revision } = this.#current();
    return this.withRollout(request, (rollout) => ({
      revision,
      request,
      measures: rollout.measures(first),
      health: rollout.health(),
    }));
  }

  /** The prediction of each expert for each frame, and the product of all. */
  predictions(request: RolloutRequest): PredictionsReport {
    const { info, revision } = this.#current();
    return using(
      this.withRollout(request, (rollout) => rollout.predictions()),
      (predictions) => {
        const parts = info.parts.map((_, target) => ({
          experts: info.parts.map((_, source) => ({
            means: predictions.expertMeans(source, target),
            variances: predictions.expertVariances(source, target),
          })),
          product: { means: predictions.means(target), variances: predictions.variances(target) },
        }));
        const all = parts.flatMap(({ experts, product }): Predictions[] => [...experts, product]);
        const arrays = all.flatMap(({ means, variances }) => [means, variances]);
        return transfer({ revision, request, firstFrame: predictions.firstFrame, parts }, ...arrays);
      },
    );
  }

  futures(request: RolloutRequest, count: number, seed: number): RolloutResult[] {
    const open = this.#current();
    const sampled = open.model.sampledRollouts(meanOf(request), count, seed);
    const results = sampled.map((rollout) => result(open, rollout, request));
    return transfer(results, ...results.flatMap(({ motion, latents }) => [motion.positions, ...latents]));
  }

  /** Looks at a rollout of the model and frees it. */
  withRollout<Found>(request: RolloutRequest, look: (rollout: Rollout, info: ModelInfo) => Found): Found {
    const { model, info } = this.#current();
    return using(rolloutOf(model, request), (rollout) => look(rollout, info));
  }

  bodyPose(latents: Float64Array): Float32Array {
    return this.#current().model.bodyPose(latents);
  }

  poseVariance(part: number, latents: Float64Array): Float64Array {
    return this.#current().model.poseVariance(part, latents);
  }

  toJson(): string {
    return this.#current().model.toJson();
  }

  /** The poses of a point, and its weight in each frame of the rollout. */
  inducing(point: InducingPoint, request: RolloutRequest): InducingReport {
    const { model, info } = this.#current();
    const latents = this.#latentsOf(request);
    const pathOf = (part: number) => latents[part] ?? new Float64Array(0);
    const width = (part: number) => info.parts[part]?.latent ?? 0;
    if (point.kind === "pose") {
      const { part, index } = point;
      const poses = [model.pose(part, row(model.poseIps(part), index, width(part)))];
      return { point, poses, frames: model.poseIpWeights(part, index, pathOf(part)) };
    }
    const { source, target, index } = point;
    const history = row(model.dynamicsIps(source, target), index, info.order * width(source));
    const poses = [
      model.pose(source, row(history, info.order - 1, width(source))),
      model.pose(target, row(model.dynamicsIvs(source, target), index, width(target))),
    ];
    return { point, poses, frames: model.dynamicsIpWeights(source, target, index, pathOf(source)) };
  }

  #current(): OpenModel {
    if (!this.#open) throw new Error("There is no model yet: train one or open one.");
    return this.#open;
  }

  /** The latents of a rollout. A visitor mostly points at several points of the same rollout. */
  #latentsOf(request: RolloutRequest): Float64Array[] {
    const open = this.#current();
    const last = this.#pointedRollout;
    if (last?.revision === open.revision && JSON.stringify(last.request) === JSON.stringify(request))
      return last.latents;
    this.#pointedRollout = roll(open, request);
    return this.#pointedRollout.latents;
  }
}

function view({ model, info, revision }: OpenModel): ModelView {
  return { revision, sha256: model.sha256(), info, ...inducingOf(model, info), trainingLatents: null };
}

/** The mean rollout, or a sampled one. */
function rolloutOf(model: Model, request: RolloutRequest): Rollout {
  const { sample } = request;
  const [sampled] = sample === undefined ? [] : model.sampledRollouts(meanOf(request), 1, sample);
  return sampled ?? model.rollout(meanOf(request));
}

function roll(open: OpenModel, request: RolloutRequest): RolloutResult {
  return result(open, rolloutOf(open.model, request), request);
}

/** A rollout as the page sees it. Frees the rollout. */
function result({ info, revision }: OpenModel, rollout: Rollout, request: RolloutRequest): RolloutResult {
  return using(rollout, () => ({
    revision,
    request,
    motion: {
      positions: rollout.positions(),
      frames: rollout.frames,
      nodes: info.figure.nodes.length,
      frameTime: info.frameTime,
    },
    latents: info.parts.map((_, part) => rollout.latents(part)),
    weights: rollout.weights(),
  }));
}

function row(values: Float64Array, index: number, width: number): Float64Array {
  return values.slice(index * width, (index + 1) * width);
}
