// What a worker of the pool does: trains one model at a time, on clips that it reads itself. No DOM.
import { Clip, Trainer, TrainingSet } from "vcgpdm/playground";
import { ClipReader } from "./clip-reader";
import type { Report, TrainedModel, Trainee, TrainingJob, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { breathe, SLICE } from "./slices";

let training: { cancelled: boolean } | null = null;
const clips = new ClipReader({ Clip, TrainingSet });

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

async function train(job: TrainingJob, report: Report): Promise<TrainingOutcome> {
  if (training) throw new Error("This worker is training already.");
  const run = { cancelled: false };
  training = run;
  let trainer: Trainer | null = null;
  try {
    const start = performance.now();
    trainer = await prepare(job);
    const parts = job.settings.parts.length;
    let steps: TrainingProgress[] = [];
    let wanted = false;
    let last: TrainingProgress | null = null;
    const send = (model: TrainedModel | null) => {
      const sent = report({ steps, elapsed: (performance.now() - start) / 1000, model });
      steps = [];
      return sent;
    };
    while (!run.cancelled && !last?.done) {
      const slice = performance.now();
      do {
        last = trainer.step();
        steps.push(last);
      } while (!last.done && performance.now() - slice < SLICE);
      if (!last.done) {
        const model = wanted ? bestSoFar(trainer, parts) : null;
        wanted = false;
        void Promise.resolve(send(model)).then((answer) => (wanted = answer));
      }
      await breathe();
    }
    // Waits until the page has it: reports and the outcome travel on different ports.
    await send(bestSoFar(trainer, parts));
    const reason = run.cancelled ? "You cancelled; this is the best so far." : (last?.reason ?? "Done.");
    return { cancelled: run.cancelled, reason };
  } finally {
    training = null;
    trainer?.free();
  }
}

export const trainee: Omit<Trainee, "start"> = {
  train,
  cancelTraining() {
    if (training) training.cancelled = true;
  },
};
