// Promises over the workers of the whole program, which is loaded when it is asked for. No wasm import.
import * as Comlink from "comlink";
import { cancellable, openWhole, watched } from "./engine";
import { type Hired, Pool } from "./pool";
import { loadWhole } from "./programs";
import type { FittingJob, LearningJob, LibraryReport } from "./library-protocol";
import type { Couplings, TrainingOutcome } from "./protocol";
import type { Evaluated, EvaluationJob, Experiment, ExperimentReport, WholeWorker } from "./whole-protocol";

/** A call to a worker answers with a promise. */
type Remote<Call> = Call extends (...given: infer Given) => infer Answer
  ? (...given: Given) => Promise<Awaited<Answer>>
  : never;

/** What is passed on as it is. */
const QUESTIONS = [
  "planComparison",
  "addOutcome",
  "openResults",
  "drawExperiment",
  "moments",
  "openLibrary",
  "nearestCouplings",
  "combinationMotion",
  "combinationText",
  "addCombination",
  "startWalk",
  "advanceWalk",
  "lockingRow",
  "openStudy",
  "changeStudy",
  "drawTrials",
  "movements",
  "analysePerception",
  "perceptionJson",
  "makeStudy",
] as const satisfies (keyof WholeWorker)[];
type Questions = (typeof QUESTIONS)[number];

/** What the page asks of a worker of the whole program. */
export type WholeProgramWorker = { [Question in Questions]: Remote<WholeWorker[Question]> } & {
  /** Answers null when the signal came first. */
  evaluate(job: EvaluationJob, report: (fraction: number) => void, signal: AbortSignal): Promise<Evaluated | null>;
  /** Keeps the best so far when the signal comes. */
  trainExperiment(
    experiment: Experiment,
    report: (report: ExperimentReport) => void,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
  /** Keeps the best so far when the signal comes. */
  learnLibrary(
    job: LearningJob,
    report: (report: LibraryReport<string>) => void,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
  /** Keeps the best so far when the signal comes. */
  fitCouplings(
    job: FittingJob,
    report: (report: LibraryReport<Couplings>) => void,
    signal: AbortSignal,
  ): Promise<TrainingOutcome>;
};

export interface WholeProgramWorkers {
  /** Trains: as many at once as the machine has cores. */
  pool: Pool<WholeProgramWorker>;
  /** Answers at once, whatever the pool is doing. */
  desk: Pool<WholeProgramWorker>;
  /** One worker, which holds the library of primitives that is looked at. */
  library: Pool<WholeProgramWorker>;
}

export interface WholeProgram {
  /** Its workers; loaded at the first time, and again after a download that failed. */
  load(): Promise<WholeProgramWorkers>;
}

function hire(wasm: WebAssembly.Module): Hired<WholeProgramWorker> {
  const { worker, name } = openWhole("whole");
  const remote = Comlink.wrap<WholeWorker>(worker);
  const ready = remote.start(wasm);
  const asked = QUESTIONS.map((question) => {
    const call = remote[question] as (...given: unknown[]) => Promise<unknown>;
    return [question, (...given: unknown[]) => call(...given)];
  });
  return {
    worker: {
      ...(Object.fromEntries(asked) as Pick<WholeProgramWorker, Questions>),
      evaluate: (job, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelEvaluation(),
          () => remote.evaluate(job, Comlink.proxy(report)),
        ),
      trainExperiment: (experiment, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelExperiment(),
          () => remote.trainExperiment(experiment, Comlink.proxy(report)),
        ),
      learnLibrary: (job, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelLibrary(),
          () => remote.learnLibrary(job, Comlink.proxy(report)),
        ),
      fitCouplings: (job, report, signal) =>
        cancellable(
          signal,
          () => remote.cancelLibrary(),
          () => remote.fitCouplings(job, Comlink.proxy(report)),
        ),
    },
    ready,
    broken: watched(worker, name, ready),
    dismiss: () => worker.terminate(),
  };
}

export class WholeEngine implements WholeProgram {
  #workers: WholeProgramWorkers | null = null;

  async load(): Promise<WholeProgramWorkers> {
    const wasm = await loadWhole();
    const cores = Math.max(1, navigator.hardwareConcurrency || 1);
    this.#workers ??= {
      pool: new Pool(cores, () => hire(wasm)),
      desk: new Pool(1, () => hire(wasm)),
      library: new Pool(1, () => hire(wasm)),
    };
    return this.#workers;
  }
}
