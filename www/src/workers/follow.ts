// How a worker takes the steps of a training and reports its progress. No DOM.
import type { Report, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { inSlices } from "./slices";

interface Training<Found> {
  step(): TrainingProgress;
  /** What the visitor should know of the data and the settings. */
  notices?(): string[];
  /** The best so far, or the result at the end; null while there is nothing worth showing. */
  find(isEnd: boolean): Found | null;
}

/** Trains to the end, or until the signal is aborted. `start`: when the work began. */
export async function follow<Found>(
  training: Training<Found>,
  report: Report<Found>,
  signal: AbortSignal,
  start = performance.now(),
): Promise<TrainingOutcome> {
  let progress = training.step();
  let steps = [progress];
  let wanted = false;
  const notices = training.notices?.() ?? [];
  let unsent = notices;
  const send = async (withBest: boolean, isEnd = false) => {
    const found = withBest ? training.find(isEnd) : null;
    const elapsed = (performance.now() - start) / 1000;
    const answer = report({ steps, progress, elapsed, found, notices: unsent });
    steps = [];
    unsent = [];
    wanted = false;
    wanted = (await answer) === true;
  };
  const step = () => {
    if (progress.done) return true;
    progress = training.step();
    steps.push(progress);
    return progress.done;
  };
  // The next slice does not wait for the page.
  const done = await inSlices(signal, step, (last) => {
    if (!last) void send(wanted);
  });
  // Waits until the page has the report: reports and the outcome travel on different ports.
  await send(true, true);
  const reason = done ? progress.reason : null;
  return { cancelled: !done, reason, notices };
}
