// Promises over the workers of the whole program, which is loaded when it is asked for. No wasm import.
import * as Comlink from "comlink";
import { cancellable, compile, watched } from "./engine";
import { messageOf } from "../ui/format";
import { type Hired, Pool } from "./pool";
import type {
  Comparer,
  Comparison,
  ComparisonSettings,
  Evaluated,
  EvaluationJob,
  ExperimentJob,
  ExperimentReport,
  Results,
  SyntheticTruth,
  TrainingClip,
  TrainingOutcome,
} from "./protocol";

/** What the page asks of a worker of the pool. */
export interface ComparingWorker {
  /** Answers null when the signal came first. */
  evaluate(job: EvaluationJob, report: (fraction: number) => void, signal: AbortSignal): Promise<Evaluated | null>;
  emptyResults(clips: TrainingClip[], settings: ComparisonSettings): Promise<Results>;
  compare(results: Results): Promise<Comparison>;
  draw(job: ExperimentJob): Promise<SyntheticTruth>;
  /** Keeps the best so far when the signal comes. */
  experiment(
    job: ExperimentJob,
    report: (report: ExperimentReport) => void,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
}

function hire(wasm: WebAssembly.Module): Hired<ComparingWorker> {
  const { worker, broken } = watched(
    new Worker(new URL("../workers/whole.ts", import.meta.url), { type: "module", name: "comparing" }),
  );
  const remote = Comlink.wrap<Comparer>(worker);
  return {
    worker: {
      evaluate: (job, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelEvaluation(),
          () => remote.evaluate(job, Comlink.proxy(report)),
        ),
      emptyResults: (clips, settings) => remote.emptyResults(clips, settings),
      compare: (results) => remote.compare(results),
      draw: (job) => remote.draw(job),
      experiment: (job, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelExperiment(),
          () => remote.experiment(job, Comlink.proxy(report)),
        ),
    },
    ready: remote.start(wasm),
    broken,
    dismiss: () => worker.terminate(),
  };
}

/** The workers of the whole program. */
export interface Workers {
  /** Trains: as many at once as the machine has cores. */
  pool: Pool<ComparingWorker>;
  /** Answers at once, whatever the pool is doing. */
  desk: Pool<ComparingWorker>;
}

let workers: Promise<Workers> | null = null;

/** Loads the whole program, once. */
export function comparing(): Promise<Workers> {
  workers ??= compile(new URL("../../../crate/wasm/pkg/web/vcgpdm_bg.wasm", import.meta.url)).then(
    (wasm) => ({
      pool: new Pool(Math.max(1, navigator.hardwareConcurrency || 1), () => hire(wasm)),
      desk: new Pool(1, () => hire(wasm)),
    }),
    (problem: unknown) => {
      throw new Error(`the program for it could not be loaded (${messageOf(problem)}). Try again when you are online.`);
    },
  );
  // A failed download may be tried again.
  workers.catch(() => (workers = null));
  return workers;
}
