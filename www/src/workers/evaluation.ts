// Comparisons: trains and scores one model in one fold, and answers questions about results. No DOM.
import { Evaluation, Fold, Results } from "vcgpdm";
import type { ComparisonWorker, Evaluated, EvaluationJob, ResultsView } from "../engine/whole-protocol";
import { clipSet } from "./clips";
import { inSlices } from "./slices";
import { transfer } from "./transfer";
import { using } from "./using";

async function foldOf({ clips: chosen, settings, heldOut, trainingTrials }: EvaluationJob): Promise<Fold> {
  return using(await clipSet(chosen), (set) => new Fold(set, settings, { heldOut, trainingTrials }));
}

async function evaluate(
  fold: Fold,
  job: EvaluationJob,
  report: (fraction: number) => void,
  signal: AbortSignal,
): Promise<Evaluated | null> {
  let start = performance.now();
  return using(new Evaluation(fold, job.candidate, job.seed), async (training) => {
    let fraction = 0;
    const step = () => {
      const progress = training.step();
      fraction = progress.fraction;
      return progress.done;
    };
    // The next slice does not wait for the page, and pauses do not count as time of the training.
    const done = await inSlices(
      signal,
      step,
      () => void report(fraction),
      (milliseconds) => {
        start += milliseconds;
      },
    );
    if (!done) return null;
    return using(training.prediction(), (prediction) => {
      const outcome = prediction.outcome((performance.now() - start) / 1000);
      const [predicted, actual] = [prediction.positions(), fold.actual()];
      return transfer({ outcome, predicted, actual, frameTime: fold.frameTime }, predicted, actual);
    });
  });
}

/** Adds the known results, if they are of the same setting; answers whether they were. */
function addKnown(results: Results, known: string | null): boolean {
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

/** The results that grow: each job of a comparison adds its outcome to the same ones. */
let growing: { text: string; results: Results } | null = null;

function resultsOf(text: string): Results {
  if (growing?.text === text) return growing.results;
  const results = Results.fromJson(text);
  growing?.results.free();
  growing = { text, results };
  return results;
}

export const comparisonWorker: ComparisonWorker = {
  evaluate: async (job, report, signal) =>
    using(await foldOf(job), (fold) => evaluate(fold, job, report, signal)),
  planComparison: async (chosen, settings, plan, known) =>
    using(await clipSet(chosen), (set) =>
      using(Results.empty(set, settings), (results) => {
        const goesOn = addKnown(results, known);
        const jobs = results.jobs(plan);
        return {
          results: view(results),
          jobs,
          costs: jobs.map(({ job }) => results.costOf(set, job)),
          goesOn,
        };
      }),
    ),
  addOutcome(text, job, outcome) {
    const results = resultsOf(text);
    growing = null;
    results.add(job, outcome);
    const added = view(results);
    growing = { text: added.text, results };
    return added;
  },
  openResults: (text) => using(Results.fromJson(text), view),
};
