// What a worker of the pool does: trains one model at a time, on clips that it reads itself. No DOM.
import { Clip, Trainer, TrainingSet } from "vcgpdm";
import type { Report, TrainedModel, Trainee, TrainingClip, TrainingJob, TrainingOutcome, TrainingProgress } from "./protocol";

/** Milliseconds of training before a report, and before messages (a cancel) get their turn. */
const SLICE = 100;

let training: { cancelled: boolean } | null = null;
/** The clips of the last job: the next one mostly has the same. */
const read = new Map<number, Clip>();

async function clipOf({ id, source }: TrainingClip): Promise<Clip> {
  let clip = read.get(id);
  if (!clip) {
    clip = "sample" in source ? Clip.sample(source.sample) : Clip.read(source.name, new Uint8Array(await source.file.arrayBuffer()));
    read.set(id, clip);
  }
  return clip;
}

async function trainingSet(chosen: readonly TrainingClip[]): Promise<TrainingSet> {
  for (const [id, clip] of read) {
    if (chosen.some((one) => one.id === id)) continue;
    read.delete(id);
    clip.free();
  }
  const set = new TrainingSet();
  try {
    for (const one of chosen) {
      const clip = await clipOf(one);
      if (one.first <= 0 && one.end >= clip.info().frames) {
        set.add(clip);
      } else {
        const piece = clip.cut(one.first, one.end);
        set.add(piece);
        piece.free();
      }
    }
    return set;
  } catch (problem) {
    set.free();
    throw problem;
  }
}

async function prepare(job: TrainingJob): Promise<Trainer> {
  const set = await trainingSet(job.clips);
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

/** Lets waiting messages in. */
function breathe(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
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
