// What the worker that shows answers, with the model. No DOM.
import {
  bestToShow,
  Clip,
  documentKind,
  Endless,
  freshSeed,
  trainingCost,
  usualSettings,
} from "vcgpdm/player";
import type { LiveBody, Workbench } from "../engine/protocol";
import { advance } from "./endless";
import { shownClip } from "./shown-clip";
import { ShownModel } from "./shown-model";
import { using } from "./using";

const model = new ShownModel();
let live: { endless: Endless; body: LiveBody } | null = null;

function endLive(): void {
  live?.endless.free();
  live = null;
}

/** The clips that it can make. The wasm of a quick build makes more than that of a first visit. */
export const samples = () => Clip.samples().filter(({ movement }) => movement.startsWith("walk"));

export const playerCalls: Omit<Workbench, "start"> = {
  freshSeed: () => freshSeed(),
  documentKind: (text) => documentKind(text),
  sampleClip: (id) => using(Clip.sample(id), shownClip),
  trainingCost({ settings, frames, longest, columns }) {
    const usual = usualSettings(longest);
    const dynamicsIps = settings.dynamicsIps || usual.dynamicsIps;
    const poseIps = settings.poseIps || usual.poseIps;
    return { ...trainingCost({ ...settings, dynamicsIps, poseIps }, frames, columns), usual, longest };
  },
  bestToShow: (ranks, errors) => bestToShow(Uint8Array.from(ranks), Float64Array.from(errors)),
  openModel: (text, frames, revision) => model.open(text, frames, revision),
  rollout: (request) => model.rollout(request),
  inducing: (point, request) => model.inducing(point, request),
  bodyPose: (latents) => model.bodyPose(latents),
  poseVariance: (part, latents) => model.poseVariance(part, latents),
  modelJson: () => model.toJson(),
  rolloutBvh: (request) => model.rolloutBvh(request),
  bodyReport: (request, first) => model.bodyReport(request, first),
  predictions: (request) => model.predictions(request),
  futures: (request, count, seed) => model.futures(request, count, seed),
  startLive(request, frame) {
    const next = model.withRollout(request, (rollout, body) => ({
      endless: new Endless(rollout, frame),
      body,
    }));
    endLive();
    live = next;
  },
  advanceLive(step) {
    if (!live) throw new Error("The live motion ended: start it again.");
    return advance(live.endless, live.body, step);
  },
  endLive,
};
