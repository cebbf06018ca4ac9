// Promises over the workers of the whole program, which is loaded when it is asked for. No wasm import.
import * as Comlink from "comlink";
import { cancellable, openWhole, watched } from "./engine";
import { type Hired, Pool } from "./pool";
import { loadWhole } from "./programs";
import type { WholeWorker } from "./whole-protocol";

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
  "isWholeLibrary",
  "combinationMoves",
  "nearestCouplings",
  "combinationMotion",
  "combinationText",
  "addCombination",
  "primitivesText",
  "addPrimitives",
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
  "readTable",
  "checkTables",
  "openSeries",
  "rolloutSeries",
  "seriesCsv",
] as const satisfies (keyof WholeWorker)[];
type Questions = (typeof QUESTIONS)[number];

/** What goes on until its signal comes, each with what brings it to an early end. */
const TASKS = {
  evaluate: "cancelEvaluation",
  trainExperiment: "cancelExperiment",
  learnLibrary: "cancelLibrary",
  fitCouplings: "cancelLibrary",
  importPrimitives: "cancelLibrary",
  holdOut: "cancelLibrary",
  trainSeries: "cancelSeries",
} as const satisfies Partial<Record<keyof WholeWorker, Extract<keyof WholeWorker, `cancel${string}`>>>;
type Tasks = keyof typeof TASKS;

/** A task is told where to report to, and when to stop. */
type Cancellable<Call> = Call extends (job: infer Job, report: infer Report) => infer Answer
  ? (job: Job, report: Report, signal: AbortSignal) => Promise<Awaited<Answer>>
  : never;

/**
 * What the page asks of a worker of the whole program. When the signal comes, trainings keep the best so far;
 * an evaluation answers null, and a fold finds nothing.
 */
export type WholeProgramWorker = { [Question in Questions]: Remote<WholeWorker[Question]> } & {
  [Task in Tasks]: Cancellable<WholeWorker[Task]>;
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
  const tasks = Object.entries(TASKS).map(([task, cancel]) => {
    const work = remote[task as Tasks] as (job: unknown, report: unknown) => Promise<unknown>;
    const call = (job: unknown, report: (told: never) => void, signal: AbortSignal) =>
      cancellable(
        signal,
        () => remote[cancel](),
        () => work(job, Comlink.proxy(report)),
      );
    return [task, call];
  });
  return {
    worker: {
      ...(Object.fromEntries(asked) as Pick<WholeProgramWorker, Questions>),
      ...(Object.fromEntries(tasks) as Pick<WholeProgramWorker, Tasks>),
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
