// A worker that was started, and how the page learns that it has died.
import { type Calls, callsOf } from "./calls";

/** Starting the program is the first call of every worker. */
interface Startable {
  start(wasm: WebAssembly.Module): Promise<unknown>;
}

export interface Running<Face> {
  calls: Calls<Face>;
  /** Fails, with a sentence for the visitor, when the worker dies. */
  broken: Promise<never>;
  dismiss(): void;
}

interface Starting<Face extends Startable> extends Running<Face> {
  /** The answer of the worker's start. */
  ready: ReturnType<Face["start"]>;
}

/** What is wrong with a worker that reports an error: only a program that runs reports what and where. */
export function workerTrouble(event: Pick<ErrorEvent, "message" | "lineno">): string {
  if (event.message || event.lineno) return `the worker that computed it stopped (${event.message})`;
  return "its program could not be loaded. Is this machine offline? Try again when it is online";
}

/** A name that no other worker has, of this page or of another tab. */
export const nameOf = (purpose: string) => `vcgpdm ${purpose} ${Date.now()} ${Math.random()}`;

/** Starts the program in a worker, which was opened with this name. */
export function startIn<Face extends Startable>(
  worker: Worker,
  name: string,
  program: Promise<WebAssembly.Module>,
): Starting<Face> {
  const calls = callsOf<Face>(worker);
  const start = calls.start as unknown as Face["start"];
  const ready = program.then((wasm) => start(wasm)) as ReturnType<Face["start"]>;
  return { calls, ready, broken: deathOf(worker, name, ready), dismiss: () => worker.terminate() };
}

/**
 * Fails when the worker dies. Some deaths send no event: but a worker that has started holds the lock of its
 * name, and the browser gives that lock to the page, which waits for it. (Only pages from https or from this
 * machine have locks.)
 */
function deathOf(worker: Worker, name: string, started: Promise<unknown>): Promise<never> {
  const broken = new Promise<never>((_, fail) => {
    worker.addEventListener("error", (event) => fail(new Error(workerTrouble(event))));
    const onDeath = () => fail(new Error("the worker that computed it stopped"));
    started.then(() => navigator.locks?.request(name, onDeath)).catch(() => {});
  });
  // Without a call under way nobody listens: a death is then no uncaught error.
  broken.catch(() => {});
  return broken;
}
