// One fold of the experiment: a trial is held out, and predicted by a library and by a model of its movement
// alone.
import type { EngineStore } from "../engine/engine-store";
import type { ModularityOutcome } from "../engine/library-protocol";
import type { SampleInfo } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { ProgressStore } from "../training/progress-store";
import { Store } from "../ui/store";

/** Iterations of each seed of a quick fold: a tenth of those of the experiment. */
const QUICK_ITERATIONS = 60;

/** The result of a fold. */
export interface FoldOutcome {
  trial: SampleInfo;
  quick: boolean;
  library: ModularityOutcome;
  alone: ModularityOutcome;
}

export class FoldStore extends Store {
  /** The two trainings, which run at the same time if there are two cores. */
  readonly library = new ProgressStore<ModularityOutcome>();
  readonly alone = new ProgressStore<ModularityOutcome>();
  readonly #whole: WholeWorkers;
  readonly #engine: Pick<EngineStore, "samples" | "on">;
  #chosen: string | null = null;
  #quick = false;
  #outcome: FoldOutcome | null = null;

  constructor(whole: WholeWorkers, engine: Pick<EngineStore, "samples" | "on">) {
    super();
    this.#whole = whole;
    this.#engine = engine;
    for (const store of [engine, this.library, this.alone]) store.on(() => this.changed());
  }

  get trials(): readonly SampleInfo[] {
    return this.#engine.samples;
  }

  /** The trial that is held out; null before the trials are current. */
  get trial(): SampleInfo | null {
    return this.trials.find(({ id }) => id === this.#chosen) ?? this.trials[0] ?? null;
  }

  choose(id: string): void {
    this.#chosen = id;
    this.changed();
  }

  /** Whether a fold has only a tenth of the iterations. */
  get quick(): boolean {
    return this.#quick;
  }

  setQuick(quick: boolean): void {
    this.#quick = quick;
    this.changed();
  }

  get busy(): boolean {
    return this.library.busy || this.alone.busy;
  }

  /** Whether both trainings are being cancelled. */
  get stopping(): boolean {
    return this.busy && [this.library, this.alone].every(({ status }) => status !== "running");
  }

  /** The result of the last fold; null before, and if the fold was cancelled or failed. */
  get outcome(): FoldOutcome | null {
    return this.#outcome;
  }

  async holdOut(): Promise<void> {
    const { trial, quick } = this;
    if (this.busy || !trial) return;
    this.#outcome = null;
    const train = (store: ProgressStore<ModularityOutcome>, alone: boolean) =>
      store.run((report, signal) => {
        const fold = { sample: trial.id, alone, ...(quick && { maxIterations: QUICK_ITERATIONS }) };
        return this.#whole.pool.run((worker) => worker.holdOut(fold, report, signal), signal);
      });
    const [library, alone] = await Promise.all([train(this.library, false), train(this.alone, true)]);
    if (library && alone) this.#outcome = { trial, quick, library, alone };
    this.changed();
  }

  cancel(): void {
    this.library.cancel();
    this.alone.cancel();
  }
}
