// Comparisons: trains and scores one model in one fold, and answers questions about results. No DOM.
import { Evaluation, Fold, Results } from "vcgpdm";
import type {
  AddedResult,
  ComparisonWorker,
  Evaluated,
  EvaluationJob,
  Job,
  Outcome,
  ResultsView,
} from "../engine/whole-protocol";
import { clipSet } from "./clips";
import { inSlices } from "./slices";
import { transfer, using } from "./using";

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
      const model = using(training.model(), (best) => best.toJson());
      return transfer({ outcome, predicted, actual, frameTime: fold.frameTime, model }, predicted, actual);
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

interface Held {
  results: Results;
  /** The file of the same setting without a result. */
  empty: string;
}

const read = (text: string): Held => ({
  results: Results.fromJson(text),
  empty: JSON.stringify({ ...JSON.parse(text), finished: [] }),
});

/** The results that grow: each job of a comparison adds its outcome to the same ones. */
let growing: (Held & { state: number }) | null = null;

/** Writes only the new result as text, because there are many jobs. */
const addTo = ({ results, empty }: Held, job: Job, outcome: Outcome): AddedResult =>
  using(Results.fromJson(empty), (added) => {
    added.add(job, outcome);
    const [id] = added.finished().map((finished) => finished.id);
    const isWhole = results.finished().some((finished) => finished.id === id);
    results.merge(added);
    const all = results.finished();
    const place = all.findIndex((finished) => finished.id === id);
    // Files end with the list of results.
    const text = isWhole ? results.toJson() : added.toJson().slice(empty.length - "]}".length, -"]}".length);
    const comparison = results.comparison();
    return { state: Math.random(), text, isWhole, finished: all[place]!, place, comparison };
  });

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
  addOutcome(from, job, outcome) {
    if (typeof from === "number" && from !== growing?.state) return null;
    const held = typeof from === "string" ? read(from) : growing!;
    if (held !== growing) growing?.results.free();
    growing = { ...held, state: 0 };
    const added = addTo(held, job, outcome);
    growing.state = added.state;
    return added;
  },
  openResults: (text) => using(Results.fromJson(text), view),
};
