// A training in its own view: its progress and its end.
import type { TrainingOutcome, TrainingProgress, TrainingReport } from "../engine/protocol";
import { messageOf } from "../ui/format";
import { Job } from "../ui/job";
import { endingWords } from "./words";

/** Carries out the training and reports its progress. */
export type Work<Found> = (
  report: (report: TrainingReport<Found>) => void,
  signal: AbortSignal,
) => Promise<TrainingOutcome>;

export class ProgressStore<Found> extends Job {
  #report: TrainingReport<Found> | null = null;

  get iteration(): number {
    return this.#report?.progress.iteration ?? 0;
  }

  /** The share of its iterations that is done. */
  get fraction(): number {
    return this.#report?.progress.fraction ?? 0;
  }

  /** Seconds since it began. */
  get elapsed(): number {
    return this.#report?.elapsed ?? 0;
  }

  /** Returns the result, also of a cancelled training; null: it failed. */
  async run(work: Work<Found>): Promise<Found | null> {
    if (this.busy) return null;
    this.#report = null;
    const signal = this.startJob();
    let found: Found | null = null;
    const seen: { last?: TrainingProgress } = {};
    try {
      const outcome = await work((report) => {
        this.#report = report;
        seen.last = report.progress;
        found = report.found ?? found;
        this.changedSoon();
      }, signal);
      this.endJob(endingWords(outcome, seen.last));
    } catch (problem) {
      found = null;
      const left = problem === signal.reason;
      this.endJob(left ? "" : messageOf(problem), !left);
    }
    return found;
  }
}
