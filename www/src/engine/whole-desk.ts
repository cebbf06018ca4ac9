// Asking a worker of the whole program, which is loaded for that where it is not there yet.
import type { WholeProgram, WholeProgramWorker } from "./whole-engine";

/** Asks the worker that answers at once. */
export async function askDesk<Answer>(
  whole: WholeProgram,
  question: (worker: WholeProgramWorker) => Promise<Answer>,
): Promise<Answer> {
  const { desk } = await whole.load();
  return desk.run(question);
}

/** Has one of those that train work on something, as soon as one is free. */
export async function workInPool<Result>(
  whole: WholeProgram,
  signal: AbortSignal,
  work: (worker: WholeProgramWorker) => Promise<Result>,
): Promise<Result> {
  const { pool } = await whole.load();
  return pool.run(work, signal);
}
