// What a worker of the pool does: trains one model at a time, on clips that it reads itself. No DOM.
import { Clip, Trainer, TrainingSet } from "vcgpdm/playground";
import type { Report, TrainedModel, Trainee, TrainingJob, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { ClipReader } from "./clip-reader";
import { OneTask, type Task } from "./slices";

const clips = new ClipReader({ Clip, TrainingSet });
const training = new OneTask();

async function prepare(job: TrainingJob): Promise<Trainer> {
  const set = await clips.set(job.clips);
  try {
    return new Trainer(set, job.settings);
  } finally {
    set.free();
  }
}

function bestSoFar(trainer: Trainer, parts: number): TrainedModel {
  const model = trainer.model();
  try {
    return { text: model.toJson(), latents: Array.from({ length: parts }, (_, part) => trainer.latents(part)) };
  } finally {
    model.free();
  }
}

async function train(job: TrainingJob, report: Report, task: Task): Promise<TrainingOutcome> {
  const start = performance.now();
  const trainer = await prepare(job);
  try {
    let steps: TrainingProgress[] = [];
    let reason: TrainingProgress["reason"] = null;
    let modelWanted = false;
    const send = async (withModel: boolean) => {
      const model = withModel ? bestSoFar(trainer, job.settings.parts.length) : null;
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
    return { cancelled: !done, reason };
  } finally {
    trainer.free();
  }
}

export const trainee: Omit<Trainee, "start"> = {
  train: (job, report) => training.run((task) => train(job, report, task)),
  cancelTraining: () => training.cancel(),
};
