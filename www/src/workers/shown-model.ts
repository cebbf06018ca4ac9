// The model that the page shows: its rollouts, and what its inducing points stand for. No DOM.
import { Model, type Rollout } from "vcgpdm/player";
import { MAX_PARTS } from "../engine/limits";
import type {
  BodyReport,
  DynamicsInducing,
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
import { transfer } from "./transfer";
import { using } from "./using";

/** A model with what is asked of it again and again. */
interface Held {
  model: Model;
  info: ModelInfo;
  /** Grows with every model that is taken up. */
  revision: number;
}

export class ShownModel {
  #held: Held | null = null;
  /** The last rollout that an inducing point was asked about. */
  #pointedRollout: RolloutResult | null = null;

  /** Takes a model up and rolls it out as learned. The one before stays where that fails. */
  open(text: string, frames: number, revision: number): OpenedModel {
    const model = Model.fromJson(text);
    try {
      const info = model.info() as ModelInfo;
      const parts = info.parts.length;
      if (parts > MAX_PARTS)
        throw new Error(
          `expected a model of ${MAX_PARTS} parts at most, found ${parts}: the page has no room for their couplings. The terminal program rolls it out`,
        );
      const next = { model, info, revision };
      const rollout = roll(next, { frames, sequence: 0, alpha: null, reading: "as-learned" });
      const opened = { model: view(next), rollout };
      this.#held?.model.free();
      this.#held = next;
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
    return this.withRollout(request, (rollout) => rollout.toBvh());
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

  /** What each expert says about each frame, and the product of all. */
  predictions(request: RolloutRequest): PredictionsReport {
    const { info, revision } = this.#current();
    return using(
      this.withRollout(request, (rollout) => rollout.predictions()),
      (said) => {
        const parts = info.parts.map((_, target) => ({
          experts: info.parts.map((_, source) => ({
            means: said.expertMeans(source, target),
            variances: said.expertVariances(source, target),
          })),
          product: { means: said.means(target), variances: said.variances(target) },
        }));
        const all = parts.flatMap(({ experts, product }): Predictions[] => [...experts, product]);
        const arrays = all.flatMap(({ means, variances }) => [means, variances]);
        return transfer({ revision, request, firstFrame: said.firstFrame, parts }, ...arrays);
      },
    );
  }

  futures(request: RolloutRequest, count: number, seed: number): RolloutResult[] {
    const held = this.#current();
    const sampled = held.model.sampledRollouts(request, count, seed);
    const results = sampled.map((rollout) => result(held, rollout, request));
    return transfer(results, ...results.flatMap(({ motion, latents }) => [motion.positions, ...latents]));
  }

  /** What `look` finds in a rollout of the model, which is let go afterwards. */
  withRollout<Found>(request: RolloutRequest, look: (rollout: Rollout, info: ModelInfo) => Found): Found {
    const { model, info } = this.#current();
    return using(model.rollout(request), (rollout) => look(rollout, info));
  }

  toJson(): string {
    return this.#current().model.toJson();
  }

  /** What a point stands for, and how much it speaks for each frame of the rollout. */
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

  #current(): Held {
    if (!this.#held) throw new Error("There is no model yet: train one or open one.");
    return this.#held;
  }

  /** The latents of a rollout; a visitor mostly points at several points about the same one. */
  #latentsOf(request: RolloutRequest): Float64Array[] {
    const held = this.#current();
    const known = this.#pointedRollout;
    if (known?.revision === held.revision && JSON.stringify(known.request) === JSON.stringify(request))
      return known.latents;
    this.#pointedRollout = roll(held, request);
    return this.#pointedRollout.latents;
  }
}

function view({ model, info, revision }: Held): ModelView {
  const parts = info.parts.map((_, i) => i);
  const dynamics = (source: number, target: number): DynamicsInducing => ({
    count: info.dynamicsIps[source]?.[target] ?? 0,
    inputs: model.dynamicsIps(source, target),
    outputs: model.dynamicsIvs(source, target),
  });
  return {
    revision,
    sha256: model.sha256(),
    info,
    poseInducing: parts.map((part) => model.poseIps(part)),
    dynamicsInducing: parts.map((source) => parts.map((target) => dynamics(source, target))),
    trainingLatents: null,
  };
}

function roll(held: Held, request: RolloutRequest): RolloutResult {
  return result(held, held.model.rollout(request), request);
}

/** What the page sees of a rollout, which is let go. */
function result({ info, revision }: Held, rollout: Rollout, request: RolloutRequest): RolloutResult {
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
