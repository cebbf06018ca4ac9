// Starts a worker, and detects its death.
import { type Calls, callsOf } from "./calls";

/** The first call of each worker starts the program. */
interface Startable {
  start(wasm: WebAssembly.Module): Promise<unknown>;
}

export interface Running<Face> {
  calls: Calls<Face>;
  /** Rejects with a sentence for the visitor when the worker dies. */
  broken: Promise<never>;
  dismiss(): void;
}

interface Starting<Face extends Startable> extends Running<Face> {
  /** The answer of the call `start`. */
  ready: ReturnType<Face["start"]>;
}

/** The reason for an error event of a worker. Only a loaded program reports a message and a line. */
export function workerTrouble(event: Pick<ErrorEvent, "message" | "lineno">): string {
  if (event.message || event.lineno) return `the worker that computed it stopped (${event.message})`;
  return "its program could not be loaded. Is this machine offline? Try again when it is online";
}

/** A name that no other worker has, neither on this page nor in another tab. */
export const nameOf = (purpose: string) => `vcgpdm ${purpose} ${Date.now()} ${Math.random()}`;

/** Starts the program in a worker with this name. */
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
 * Rejects when the worker dies. Some deaths send no event. A started worker therefore holds a lock with its
 * name, and the page requests the same lock: the browser grants it when the worker is dead. (Locks exist only
 * on pages from https or from localhost.)
 */
function deathOf(worker: Worker, name: string, started: Promise<unknown>): Promise<never> {
  const broken = new Promise<never>((_, fail) => {
    worker.addEventListener("error", (event) => fail(new Error(workerTrouble(event))));
    const onDeath = () => fail(new Error("the worker that computed it stopped"));
    started.then(() => navigator.locks?.request(name, onDeath)).catch(() => {});
  });
  // Without an unfinished call nothing handles the rejection. It must not count as an uncaught error.
  broken.catch(() => {});
  return broken;
}
