// What a worker does to compare models: trains one in one fold, step by step, and scores its prediction. No DOM.
import * as Comlink from "comlink";
import { Clip, compare, emptyResults, Evaluation, Fold, TrainingSet } from "vcgpdm";
import { ClipReader } from "./clip-reader";
import type { Comparer, Evaluated, EvaluationJob, Experimenter } from "../engine/protocol";
import { breathe, SLICE } from "./slices";

const clips = new ClipReader({ Clip, TrainingSet });
let evaluation: { cancelled: boolean } | null = null;

async function foldOf({ clips: chosen, settings, heldOut, trainingTrials }: EvaluationJob): Promise<Fold> {
  const set = await clips.set(chosen);
  try {
    return new Fold(set, settings, heldOut, trainingTrials);
  } finally {
    set.free();
  }
}

async function evaluate(job: EvaluationJob, report: (fraction: number) => void): Promise<Evaluated | null> {
  if (evaluation) throw new Error("This worker is evaluating already.");
  const run = { cancelled: false };
  evaluation = run;
  const owned: { free(): void }[] = [];
  const own = <T extends { free(): void }>(one: T): T => {
    owned.push(one);
    return one;
  };
  try {
    const fold = own(await foldOf(job));
    const start = performance.now();
    const training = own(new Evaluation(fold, job.candidate, job.seed));
    let paused = 0;
    for (let done = false; !done; ) {
      const slice = performance.now();
      let fraction = 0;
      do {
        ({ done, fraction } = training.step());
      } while (!done && performance.now() - slice < SLICE);
      report(fraction);
      const pause = performance.now();
      await breathe();
      paused += performance.now() - pause;
      if (run.cancelled) return null;
    }
    const prediction = own(training.prediction());
    const seconds = (performance.now() - start - paused) / 1000;
    const outcome = prediction.outcome(seconds);
    const [predicted, actual] = [prediction.positions(), fold.actual()];
    const evaluated = { outcome, predicted, actual, frameTime: fold.frameTime };
    return Comlink.transfer(evaluated, [predicted.buffer, actual.buffer]);
  } finally {
    evaluation = null;
    owned.reverse().forEach((one) => one.free());
  }
}

export const evaluator: Omit<Comparer, "start" | keyof Experimenter> = {
  evaluate,
  cancelEvaluation() {
    if (evaluation) evaluation.cancelled = true;
  },
  async emptyResults(chosen, settings) {
    const set = await clips.set(chosen);
    try {
      return emptyResults(set, settings);
    } finally {
      set.free();
    }
  },
  compare: (results) => compare(results),
};
