// Owns the wasm: the clips and the current model; and what workers of the pool do. No DOM.
import * as Comlink from "comlink";
import init, { Clip, freshSeed, Model, TrainingSet, version } from "vcgpdm/playground";
import type {
  DynamicsInducing,
  InducingPoint,
  InducingReport,
  LoadedClip,
  ModelInfo,
  ModelView,
  OpenedModel,
  RolloutRequest,
  RolloutResult,
  Workbench,
} from "../engine/protocol";
import { trainee } from "./training";

/** A model that is shown. */
interface Held {
  model: Model;
  info: ModelInfo;
  /** Grows with every model that is taken up. */
  revision: number;
}

const clips = new Map<number, Clip>();
let lastClip = 0;
let held: Held | null = null;
let lastRevision = 0;
/** The last rollout whose latents were asked for, for the frames that an inducing point speaks for. */
let rolled: RolloutResult | null = null;

function current(): Held {
  if (!held) throw new Error("There is no model yet: train one or open one.");
  return held;
}

/** Sends the buffers over instead of copying them. */
function handOver<T extends object>(value: T, ...arrays: ArrayBufferView[]): T {
  return Comlink.transfer(
    value,
    arrays.map((a) => a.buffer as ArrayBuffer),
  );
}

function loaded(clip: Clip): LoadedClip {
  const info = clip.info();
  const motion = {
    positions: clip.positions(),
    frames: info.frames,
    nodes: info.figure.nodes.length,
    frameTime: info.frameTime,
  };
  const id = ++lastClip;
  clips.set(id, clip);
  return handOver({ id, info, motion }, motion.positions);
}

function clipOf(id: number): Clip {
  const clip = clips.get(id);
  if (!clip) throw new Error(`Clip ${id} is no longer open.`);
  return clip;
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
    info,
    poseInducing: parts.map((part) => model.poseIps(part)),
    dynamicsInducing: parts.map((source) => parts.map((target) => dynamics(source, target))),
    trainingLatents: null,
  };
}

function roll({ model, info, revision }: Held, request: RolloutRequest): RolloutResult {
  const rollout = model.rollout(request);
  try {
    return {
      revision,
      request,
      motion: {
        positions: rollout.positions(),
        frames: rollout.frames,
        nodes: info.figure.nodes.length,
        frameTime: info.frameTime,
      },
      latents: info.parts.map((_, part) => rollout.latents(part)),
      weights: model.weights(request.alpha ?? info.alpha),
    };
  } finally {
    rollout.free();
  }
}

/** Takes a model up as the current one and rolls it out as learned. The one before stays where that fails. */
function takeUp(model: Model, frames: number): OpenedModel {
  try {
    const next = { model, info: model.info(), revision: lastRevision + 1 };
    const rollout = roll(next, { frames, sequence: 0, alpha: null, reading: "as learned" });
    const opened = { model: view(next), rollout };
    held?.model.free();
    held = next;
    lastRevision = next.revision;
    return opened;
  } catch (problem) {
    model.free();
    throw problem;
  }
}

function sameRollout(a: RolloutRequest, b: RolloutRequest): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

function inducing(point: InducingPoint, request: RolloutRequest): InducingReport {
  const now = current();
  if (rolled?.revision !== now.revision || !sameRollout(rolled.request, request)) rolled = roll(now, request);
  const { model, info } = now;
  const { order, parts } = info;
  const latents = (part: number) => rolled?.latents[part] ?? new Float64Array(0);
  const width = (part: number) => parts[part]?.latent ?? 0;
  const row = (values: Float64Array, index: number, width: number) => values.slice(index * width, (index + 1) * width);
  if (point.kind === "pose") {
    const { part, index } = point;
    const poses = [model.pose(part, row(model.poseIps(part), index, width(part)))];
    return { point, poses, frames: model.poseIpWeights(part, index, latents(part)) };
  }
  const { source, target, index } = point;
  const history = row(model.dynamicsIps(source, target), index, order * width(source));
  const poses = [
    model.pose(source, row(history, order - 1, width(source))),
    model.pose(target, row(model.dynamicsIvs(source, target), index, width(target))),
  ];
  return { point, poses, frames: model.dynamicsIpWeights(source, target, index, latents(source)) };
}

const workbench: Workbench = {
  async start(wasm) {
    await init({ module_or_path: wasm });
    return { version: version(), samples: Clip.samples() };
  },
  freshSeed: () => freshSeed(),
  readClip: (name, bytes) => loaded(Clip.read(name, bytes)),
  sampleClip: (id) => loaded(Clip.sample(id)),
  dropClip(id) {
    clips.get(id)?.free();
    clips.delete(id);
  },
  checkTogether(ids) {
    const set = new TrainingSet();
    try {
      for (const id of ids) set.add(clipOf(id));
    } finally {
      set.free();
    }
  },
  openModel: (text, frames) => takeUp(Model.fromJson(text), frames),
  rollout(request) {
    const result = roll(current(), request);
    return handOver(result, result.motion.positions, ...result.latents);
  },
  inducing,
  modelJson: () => current().model.toJson(),
  rolloutBvh(request) {
    const rollout = current().model.rollout(request);
    try {
      return rollout.toBvh();
    } finally {
      rollout.free();
    }
  },
};

// One program for both: a worker of the pool is never asked for the rest.
Comlink.expose({ ...trainee, ...workbench });
