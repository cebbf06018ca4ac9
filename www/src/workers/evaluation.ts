// What a worker does for comparisons: trains and scores one model in one fold, and answers questions about
// results. No DOM.
import * as Comlink from "comlink";
import { Clip, Evaluation, Fold, Results, TrainingSet } from "vcgpdm";
import type { ComparisonWorker, Evaluated, EvaluationJob, ResultsView } from "../engine/whole-protocol";
import { ClipReader } from "./clip-reader";
import { OneTask, type Task } from "./slices";
import { using } from "./using";

const clips = new ClipReader({ Clip, TrainingSet });
const evaluation = new OneTask();

async function usingAsync<Value extends { free(): void }, Result>(
  value: Value,
  use: (value: Value) => Promise<Result>,
): Promise<Result> {
  try {
    return await use(value);
  } finally {
    value.free();
  }
}

async function foldOf({ clips: chosen, settings, heldOut, trainingTrials }: EvaluationJob): Promise<Fold> {
  return using(await clips.set(chosen), (set) => new Fold(set, settings, heldOut, trainingTrials));
}

async function evaluate(
  job: EvaluationJob,
  report: (fraction: number) => void,
  task: Task,
): Promise<Evaluated | null> {
  return usingAsync(await foldOf(job), (fold) => {
    const start = performance.now();
    return usingAsync(new Evaluation(fold, job.candidate, job.seed), async (training) => {
      let fraction = 0;
      const step = () => {
        const progress = training.step();
        fraction = progress.fraction;
        return progress.done;
      };
      // The next slice does not wait for the page: that would be no training, and is not to count as its
      // time.
      const done = await task.inSlices(step, () => void report(fraction));
      if (!done) return null;
      return using(training.prediction(), (prediction) => {
        const seconds = (performance.now() - start - task.paused) / 1000;
        const outcome = prediction.outcome(seconds);
        const [predicted, actual] = [prediction.positions(), fold.actual()];
        const evaluated = { outcome, predicted, actual, frameTime: fold.frameTime };
        return Comlink.transfer(evaluated, [predicted.buffer, actual.buffer]);
      });
    });
  });
}

/** Whether the known results are of the same setting, and so have been merged in. */
function takeOver(results: Results, known: string | null): boolean {
  if (known === null) return false;
  return using(Results.fromJson(known), (other) => {
    try {
      results.merge(other);
      return true;
    } catch {
      return false;
    }
  });
}

const view = (results: Results): ResultsView => ({
  text: results.toJson(),
  setting: results.setting(),
  finished: results.finished(),
  comparison: results.comparison(),
});

export const comparisonWorker: ComparisonWorker = {
  evaluate: (job, report) => evaluation.run((task) => evaluate(job, report, task)),
  cancelEvaluation: () => evaluation.cancel(),
  planComparison: async (chosen, settings, plan, known) =>
    using(await clips.set(chosen), (set) =>
      using(Results.empty(set, settings), (results) => {
        const goesOn = takeOver(results, known);
        const jobs = results.jobs(plan);
        return {
          results: view(results),
          jobs,
          costs: jobs.map(({ job }) => results.costOf(set, job)),
          goesOn,
        };
      }),
    ),
  addOutcome: (text, job, outcome) =>
    using(Results.fromJson(text), (results) => {
      results.add(job, outcome);
      return view(results);
    }),
  openResults: (text) => using(Results.fromJson(text), view),
};
