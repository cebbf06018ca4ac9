// Promises over the workers. The page knows the model only through this.
import * as Comlink from "comlink";
import { messageOf } from "../ui/format";
import { type Hired, Pool } from "./pool";
import { loadPlayer, loadWhole, loadWholeWhenIdle } from "./programs";
import { isTrap, SupervisedEngine, type SupervisedEvents } from "./supervised";
import type {
  Engine,
  Report,
  SampleInfo,
  Trainee,
  TrainingJob,
  TrainingOutcome,
  Workbench,
} from "./protocol";

/** Trains until it is done, or until the signal asks for the best so far. */
export interface TrainingWorker {
  train(job: TrainingJob, report: Report, signal: AbortSignal): Promise<TrainingOutcome>;
  /** Goes on with what it trained last, for so many iterations more. */
  goOn(iterations: number, report: Report, signal: AbortSignal): Promise<TrainingOutcome>;
}

/** What is wrong with a worker that reports an error: only a program that runs reports what and where. */
export function workerTrouble(event: Pick<ErrorEvent, "message" | "lineno">): string {
  if (event.message || event.lineno) return `the worker that computed it stopped (${event.message})`;
  return "its program could not be loaded. Is this machine offline? Try again when it is online";
}

/** A name that no other worker has, of this page or of another tab. */
export const nameOf = (what: string) => `vcgpdm ${what} ${Date.now()} ${Math.random()}`;

/**
 * A worker, with a promise that fails when it dies. Some deaths send no event: but a worker that has started
 * holds the lock of its name, and the browser gives that to the next who waits for it. `started` is kept when
 * the worker has it. (Only pages from https or from this machine have locks.)
 */
export function watched(worker: Worker, name: string, started: Promise<unknown>) {
  const broken = new Promise<never>((_, fail) => {
    worker.addEventListener("error", (event) => fail(new Error(workerTrouble(event))));
    const mourn = () => fail(new Error("the worker that computed it stopped"));
    started.then(() => navigator.locks?.request(name, mourn)).catch(() => {});
  });
  // Whoever asks it something hears of it; nobody else must.
  broken.catch(() => {});
  return broken;
}

/** A worker of the whole program. */
export function openWhole(what: string) {
  const name = nameOf(what);
  return {
    name,
    worker: new Worker(new URL("../workers/whole.ts", import.meta.url), { type: "module", name }),
  };
}

/** A trap of the wasm names an instruction, which is no news to a person. */
function inWords(problem: unknown): unknown {
  if (!isTrap(problem)) return problem;
  return new Error(`the program stopped (${problem.message}), perhaps for want of memory.`);
}

/** Work under way that `cancel` brings to an early end when the signal comes. */
export async function cancellable<Result>(
  signal: AbortSignal,
  cancel: () => unknown,
  work: () => Promise<Result>,
): Promise<Result> {
  signal.throwIfAborted();
  const stop = () => void cancel();
  signal.addEventListener("abort", stop);
  try {
    return await work();
  } catch (problem) {
    throw inWords(problem);
  } finally {
    signal.removeEventListener("abort", stop);
  }
}

function hire(): Hired<TrainingWorker> {
  const { worker, name } = openWhole("training");
  const remote = Comlink.wrap<Trainee>(worker);
  const ready = loadWhole().then((wasm) => remote.start(wasm));
  const heard = (signal: AbortSignal, work: () => Promise<TrainingOutcome>) =>
    cancellable(signal, () => remote.cancelTraining(), work);
  return {
    worker: {
      train: (job, report, signal) => heard(signal, () => remote.train(job, Comlink.proxy(report))),
      goOn: (iterations, report, signal) =>
        heard(signal, () => remote.goOn(iterations, Comlink.proxy(report))),
    },
    ready,
    broken: watched(worker, name, ready),
    dismiss: () => worker.terminate(),
  };
}

export interface StartedEngine {
  engine: Engine;
  pool: Pool<TrainingWorker>;
  version: string;
  samples: SampleInfo[];
}

/** A worker that shows, and what it says when it has started. */
async function startWorkbench(program: Promise<WebAssembly.Module>) {
  const name = nameOf("model");
  const worker = new Worker(new URL("../workers/player.ts", import.meta.url), { type: "module", name });
  const remote = Comlink.wrap<Workbench>(worker);
  const started = program.then((wasm) => remote.start(wasm));
  const broken = watched(worker, name, started);
  const said = await Promise.race([started, broken]);
  return { running: { remote, broken, dismiss: () => worker.terminate() }, ...said };
}

/**
 * Starts the worker that shows. The promise fails, with words for a person, where wasm or workers are
 * missing.
 */
export async function startEngine(events: SupervisedEvents): Promise<StartedEngine> {
  if (typeof WebAssembly !== "object") {
    throw new Error("this browser has no WebAssembly, which the model needs.");
  }
  const program = loadPlayer();
  const start = () =>
    startWorkbench(program).catch((problem: unknown) => {
      throw new Error(
        `its program could not be loaded (${messageOf(problem)}). Reloading the page may help.`,
      );
    });
  const { running, version, samples } = await start();
  const { engine } = new SupervisedEngine(running, async () => (await start()).running, events);
  const pool = new Pool(Math.max(1, navigator.hardwareConcurrency || 1), hire);
  loadWholeWhenIdle();
  return { engine, pool, version, samples };
}
