// Runs that stopped before their bound had settled: each can go on in the worker that trained it, which is
// kept for it.
import type { TrainingWorker } from "../engine/whole-workers";
import type { EngineStore } from "../engine/engine-store";
import type { Report, TrainedModel, TrainingOutcome } from "../engine/protocol";
import type { Run } from "./runs";

/** What a training under way needs of the page. */
export interface Send {
  report: Report<TrainedModel>;
  signal: AbortSignal;
  /** The worker begins now. */
  begun(): void;
}

interface Held {
  worker: TrainingWorker;
  bound: number;
}

export class Kept {
  readonly #engine: EngineStore;
  readonly #held = new Map<Run, Held>();

  constructor(engine: EngineStore) {
    this.#engine = engine;
  }

  has(run: Run): boolean {
    const held = this.#held.get(run);
    return held !== undefined && (this.#engine.pool?.keeps(held.worker) ?? false);
  }

  /** Keeps the worker of a run; of more runs than the pool is wide, the one of the lowest bound is let go. */
  keep(run: Run, worker: TrainingWorker, bound: number): void {
    const { pool } = this.#engine;
    if (!pool) return;
    this.#held.set(run, { worker, bound });
    pool.keep(worker);
    if (this.#held.size <= pool.width) return;
    const [lowest] = [...this.#held].sort(([, a], [, b]) => a.bound - b.bound)[0] ?? [];
    if (lowest) this.letGo(lowest);
  }

  letGo(run: Run): void {
    const held = this.#held.get(run);
    if (!held) return;
    this.#held.delete(run);
    this.#engine.pool?.letGo(held.worker);
  }

  letGoAll(): void {
    for (const run of [...this.#held.keys()]) this.letGo(run);
  }

  /** Goes on with a run, and allows it so many iterations more. It is let go when its bound has settled. */
  async goOn(run: Run, more: number, { report, signal, begun }: Send): Promise<TrainingOutcome> {
    const held = this.#held.get(run);
    const { pool } = this.#engine;
    if (!held || !pool) throw new Error("The worker that trained it is gone.");
    const work = (worker: TrainingWorker) => {
      begun();
      return worker.goOn(more, report, signal);
    };
    const outcome = await pool.run(work, signal, held.worker);
    if (outcome.reason === "settled") this.letGo(run);
    return outcome;
  }
}
