// Runs that stopped before their bound had settled. The worker that trained a run is reserved, so that the
// run can continue there.
import type { TrainingWorker } from "../engine/whole-workers";
import type { EngineStore } from "../engine/engine-store";
import type { Report, TrainedModel, TrainingOutcome } from "../engine/protocol";
import type { Run } from "./runs";
import { lab } from "../words/lab";

/** The connection of a training to the page. */
export interface Send {
  report: Report<TrainedModel>;
  signal: AbortSignal;
  /** The worker begins to train. */
  begun(): void;
}

interface PausedRun {
  worker: TrainingWorker;
  bound: number;
}

export class PausedRuns {
  readonly #workers = new Map<Run, PausedRun>();

  constructor(private readonly engine: EngineStore) {}

  has(run: Run): boolean {
    const paused = this.#workers.get(run);
    return paused !== undefined && (this.engine.pool?.keeps(paused.worker) ?? false);
  }

  /**
   * Reserves the worker of a run. When all workers are reserved, the run of the lowest bound loses its own.
   */
  keep(run: Run, worker: TrainingWorker, bound: number): void {
    const { pool } = this.engine;
    if (!pool) return;
    this.#workers.set(run, { worker, bound });
    pool.keep(worker);
    if (this.#workers.size <= pool.width) return;
    const [lowest] = [...this.#workers].sort(([, a], [, b]) => a.bound - b.bound)[0] ?? [];
    if (lowest) this.release(lowest);
  }

  release(run: Run): void {
    const paused = this.#workers.get(run);
    if (!paused) return;
    this.#workers.delete(run);
    this.engine.pool?.letGo(paused.worker);
  }

  releaseAll(): void {
    for (const run of [...this.#workers.keys()]) this.release(run);
  }

  /** Continues a run for at most `more` iterations. A run whose bound has settled releases its worker. */
  async goOn(run: Run, more: number, { report, signal, begun }: Send): Promise<TrainingOutcome> {
    const paused = this.#workers.get(run);
    const { pool } = this.engine;
    if (!paused || !pool) throw new Error(lab().learn.training.workerGone);
    const work = (worker: TrainingWorker) => {
      begun();
      return worker.goOn(more, report, signal);
    };
    const outcome = await pool.run(work, signal, paused.worker);
    if (outcome.reason === "settled") this.release(run);
    return outcome;
  }
}
