// A training in its own view: its progress and its end.
import type { TrainingOutcome, TrainingProgress, TrainingReport } from "../engine/protocol";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { endingWords } from "./words";

/** Carries out the training and reports its progress. */
export type Work<Found> = (
  report: (report: TrainingReport<Found>) => void,
  signal: AbortSignal,
) => Promise<TrainingOutcome>;

export class ProgressStore<Found> extends Store {
  #status: "idle" | "running" | "cancelling" = "idle";
  #report: TrainingReport<Found> | null = null;
  #ending = { words: "", failed: false };
  #stop = new AbortController();

  get status(): "idle" | "running" | "cancelling" {
    return this.#status;
  }

  get busy(): boolean {
    return this.#status !== "idle";
  }

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

  /** How the last one ended; empty before. */
  get ending(): { words: string; failed: boolean } {
    return this.#ending;
  }

  /** Returns the result, also of a cancelled training; null: it failed. */
  async run(work: Work<Found>): Promise<Found | null> {
    if (this.busy) return null;
    this.#status = "running";
    this.#report = null;
    this.#ending = { words: "", failed: false };
    this.#stop = new AbortController();
    this.changed();
    let found: Found | null = null;
    const seen: { last?: TrainingProgress } = {};
    try {
      const outcome = await work((report) => {
        this.#report = report;
        seen.last = report.progress;
        found = report.found ?? found;
        this.changedSoon();
      }, this.#stop.signal);
      this.#ending = { words: endingWords(outcome, seen.last), failed: false };
    } catch (problem) {
      found = null;
      const left = problem === this.#stop.signal.reason;
      this.#ending = left ? { words: "", failed: false } : { words: messageOf(problem), failed: true };
    }
    this.#status = "idle";
    this.changed();
    return found;
  }

  /** Stops the training, which keeps its best model. */
  cancel(): void {
    if (this.#status !== "running") return;
    this.#status = "cancelling";
    this.#stop.abort();
    this.changed();
  }
}
