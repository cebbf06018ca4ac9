// Trains one model at a time, and keeps the training until the next. No DOM.
import { type Model, Trainer } from "vcgpdm";
import type { Health, Report, TrainedModel, Trainee, TrainingJob, TrainingOutcome } from "../engine/protocol";
import { clipSet } from "./clips";
import { follow } from "./follow";
import { using } from "./using";

/** The newest training, which can continue. */
let kept: { trainer: Trainer; job: TrainingJob } | null = null;

function healthOf(model: Model, frames: number): Health | null {
  try {
    return using(model.rollout({ frames, sequence: 0 }), (rollout) => rollout.health());
  } catch {
    // A rollout with numbers that are not finite has no poses.
    return null;
  }
}

/** The best model so far. Its error takes longest, and decides only after the end. */
function bestSoFar(trainer: Trainer, { settings, frames }: TrainingJob, isEnd: boolean): TrainedModel {
  return using(trainer.model(), (model) => {
    const error = isEnd ? (trainer.rolloutError() ?? null) : null;
    const latents = settings.parts.map((_, part) => trainer.latents(part));
    return { text: model.toJson(), latents, health: healthOf(model, frames), error };
  });
}

function carryOut(
  report: Report<TrainedModel>,
  signal: AbortSignal,
  start?: number,
): Promise<TrainingOutcome> {
  if (!kept) throw new Error("There is no training to go on with.");
  const { trainer, job } = kept;
  const training = {
    step: () => trainer.step(),
    notices: () => trainer.notices(),
    find: (isEnd: boolean) => bestSoFar(trainer, job, isEnd),
  };
  return follow(training, report, signal, start);
}

export const trainee: Omit<Trainee, "start"> = {
  async train(job, report, signal) {
    const start = performance.now();
    kept?.trainer.free();
    kept = null;
    const trainer = using(await clipSet(job.clips), (set) => new Trainer(set, job.settings));
    kept = { trainer, job };
    return carryOut(report, signal, start);
  },
  async goOn(iterations, report, signal) {
    kept?.trainer.extend(iterations);
    return carryOut(report, signal);
  },
};
