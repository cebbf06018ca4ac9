// Owns the wasm: the clips and the current model; and what workers of the pool do. No DOM.
import * as Comlink from "comlink";
import init, { Clip, freshSeed, Model, TrainingSet, version } from "vcgpdm/playground";
import type {
  DynamicsInducing,
  InducingPoint,
  InducingReport,
  LoadedClip,
  ModelView,
  OpenedModel,
  RolloutRequest,
  RolloutResult,
  Workbench,
} from "../engine/protocol";
import { trainee } from "./training";

const clips = new Map<number, Clip>();
let lastClip = 0;
let model: Model | null = null;
let revision = 0;
/** The latents of the last rollout, for the frames an inducing point speaks for. */
let rolled: RolloutResult | null = null;

function currentModel(): Model {
  if (!model) throw new Error("There is no model yet: train one or open one.");
  return model;
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

function view(of: Model): ModelView {
  const info = of.info();
  const parts = info.parts.map((_, i) => i);
  const dynamics = (source: number, target: number): DynamicsInducing => ({
    count: info.dynamicsIps[source]?.[target] ?? 0,
    inputs: of.dynamicsIps(source, target),
    outputs: of.dynamicsIvs(source, target),
  });
  return {
    revision,
    info,
    poseInducing: parts.map((part) => of.poseIps(part)),
    dynamicsInducing: parts.map((source) => parts.map((target) => dynamics(source, target))),
    trainingLatents: null,
  };
}

function roll(of: Model, request: RolloutRequest): RolloutResult {
  const info = of.info();
  const rollout = of.rollout(request);
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
      weights: of.weights(request.alpha ?? info.alpha),
    };
  } finally {
    rollout.free();
  }
}

/** Takes a model up as the current one and rolls it out as learned. */
function takeUp(next: Model, frames: number): OpenedModel {
  const before = model;
  revision += 1;
  model = next;
  try {
    const opened = {
      model: view(next),
      rollout: roll(next, { frames, sequence: 0, alpha: null, reading: "as learned" }),
    };
    before?.free();
    return opened;
  } catch (problem) {
    model = before;
    next.free();
    throw problem;
  }
}

function sameRollout(a: RolloutRequest, b: RolloutRequest): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

function inducing(point: InducingPoint, request: RolloutRequest): InducingReport {
  const of = currentModel();
  if (!rolled || rolled.revision !== revision || !sameRollout(rolled.request, request)) {
    rolled = roll(of, request);
  }
  const row = (values: Float64Array, index: number, width: number) => values.slice(index * width, (index + 1) * width);
  if (point.kind === "pose") {
    const { part, index } = point;
    const q = of.info().parts[part]?.latent ?? 0;
    const poses = [of.pose(part, row(of.poseIps(part), index, q))];
    return { point, poses, frames: of.poseIpWeights(part, index, rolled.latents[part]!) };
  }
  const { source, target, index } = point;
  const { parts, order } = of.info();
  const qs = parts[source]?.latent ?? 0;
  const qt = parts[target]?.latent ?? 0;
  const history = row(of.dynamicsIps(source, target), index, order * qs);
  const poses = [
    of.pose(source, history.slice((order - 1) * qs)),
    of.pose(target, row(of.dynamicsIvs(source, target), index, qt)),
  ];
  const frames = of.dynamicsIpWeights(source, target, index, rolled.latents[source]!);
  return { point, poses, frames };
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
    const result = roll(currentModel(), request);
    return handOver(result, result.motion.positions, ...result.latents);
  },
  inducing,
  modelJson: () => currentModel().toJson(),
  rolloutBvh(request) {
    const rollout = currentModel().rollout(request);
    try {
      return rollout.toBvh();
    } finally {
      rollout.free();
    }
  },
};

// One program for both: a worker of the pool is never asked for the rest.
Comlink.expose({ ...trainee, ...workbench });
