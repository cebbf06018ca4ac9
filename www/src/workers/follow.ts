// How a worker takes the steps of a training and tells how far it is. No DOM.
import type { LibraryReport } from "../engine/library-protocol";
import type { TrainingOutcome, TrainingProgress } from "../engine/protocol";
import type { Task } from "./slices";

interface Steps {
  step(): TrainingProgress;
  /** What was more than the data allow, and was reduced. */
  notices?(): string[];
}

/** Takes steps until they are over or cancelled; the last report brings what was found. */
export async function follow<Found>(
  { trainer, find }: { trainer: Steps; find(): Found | null },
  report: (report: LibraryReport<Found>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const start = performance.now();
  const elapsed = () => (performance.now() - start) / 1000;
  let progress = trainer.step();
  const step = () => {
    if (!progress.done) progress = trainer.step();
    return progress.done;
  };
  const done = await task.inSlices(step, () => report({ progress, elapsed: elapsed(), found: null }));
  // Waits until the page has it: reports and the outcome travel on different ports.
  await report({ progress, elapsed: elapsed(), found: find() });
  return { cancelled: !done, reason: done ? progress.reason : null, notices: trainer.notices?.() ?? [] };
}
