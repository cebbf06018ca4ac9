// What a worker of the pool does: trains one model at a time, on clips that it reads itself. No DOM.
import { Clip, type Model, Trainer, TrainingSet } from "vcgpdm";
import type {
  Health,
  Report,
  TrainedModel,
  Trainee,
  TrainingJob,
  TrainingOutcome,
  TrainingProgress,
} from "../engine/protocol";
import { ClipReader } from "./clip-reader";
import { OneTask, type Task } from "./slices";
import { using } from "./using";

const clips = new ClipReader({ Clip, TrainingSet });
const training = new OneTask();

async function prepare(job: TrainingJob): Promise<Trainer> {
  return using(await clips.set(job.clips), (set) => new Trainer(set, job.settings));
}

/** What the worker trained last: it can go on. */
let held: { trainer: Trainer; job: TrainingJob } | null = null;

function healthOf(model: Model, frames: number): Health | null {
  try {
    return using(model.rollout({ frames, sequence: 0 }), (rollout) => rollout.health());
  } catch {
    // What is not finite has no poses.
    return null;
  }
}

function bestSoFar(trainer: Trainer, { settings, frames }: TrainingJob): TrainedModel {
  return using(trainer.model(), (model) => {
    const latents = settings.parts.map((_, part) => trainer.latents(part));
    return { text: model.toJson(), latents, health: healthOf(model, frames) };
  });
}

async function train(job: TrainingJob, report: Report, task: Task): Promise<TrainingOutcome> {
  const start = performance.now();
  held?.trainer.free();
  held = null;
  held = { trainer: await prepare(job), job };
  return follow(held, start, report, task);
}

async function goOn(iterations: number, report: Report, task: Task): Promise<TrainingOutcome> {
  if (!held) throw new Error("There is no training to go on with.");
  held.trainer.extend(iterations);
  return follow(held, performance.now(), report, task);
}

/** Trains to the end, or until a cancel comes. */
async function follow(
  { trainer, job }: NonNullable<typeof held>,
  start: number,
  report: Report,
  task: Task,
): Promise<TrainingOutcome> {
  let steps: TrainingProgress[] = [];
  let reason: TrainingProgress["reason"] = null;
  let modelWanted = false;
  const send = async (withModel: boolean) => {
    const model = withModel ? bestSoFar(trainer, job) : null;
    const sent = report({ steps, elapsed: (performance.now() - start) / 1000, model });
    steps = [];
    modelWanted = false;
    modelWanted = await sent;
  };
  const step = () => {
    const progress = trainer.step();
    steps.push(progress);
    reason = progress.reason;
    return progress.done;
  };
  // The next slice does not wait for the page; the last report brings the model in any case.
  const done = await task.inSlices(step, (last) => {
    if (!last) void send(modelWanted);
  });
  // Waits until the page has it: reports and the outcome travel on different ports.
  await send(true);
  return { cancelled: !done, reason, notices: trainer.notices() };
}

export const trainee: Omit<Trainee, "start"> = {
  train: (job, report) => training.run((task) => train(job, report, task)),
  goOn: (iterations, report) => training.run((task) => goOn(iterations, report, task)),
  cancelTraining: () => training.cancel(),
};
