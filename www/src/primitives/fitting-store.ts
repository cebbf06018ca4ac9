// The couplings of the walking combination, fitted to a clip with fixed primitives.
import type { ClipsStore } from "../clips/clips-store";
import type { Fitted } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { LibraryStore } from "./library-store";
import { ProgressStore } from "../training/progress-store";

const MOST_ITERATIONS = 100;

export class FittingStore extends ProgressStore<Fitted> {
  readonly #whole: WholeWorkers;
  readonly #clips: Pick<ClipsStore, "all">;
  readonly #library: LibraryStore;

  constructor(whole: WholeWorkers, clips: Pick<ClipsStore, "all">, library: LibraryStore) {
    super();
    this.#whole = whole;
    this.#clips = clips;
    this.#library = library;
  }

  /** Fits to the clip of this key, and sets the sliders to the result. */
  async fit(key: string): Promise<void> {
    const clip = this.#clips.all.find((clip) => clip.key === key);
    const { current, uses } = this.#library;
    if (!clip || !current) return;
    const { loaded, source, first, end } = clip;
    const job = {
      library: current.text,
      uses: [...uses],
      clips: [{ id: loaded.id, source, first, end }],
      maxIterations: MOST_ITERATIONS,
    };
    const fitted = await this.run((report, signal) =>
      this.#whole.pool.run((worker) => worker.fitCouplings(job, report, signal), signal),
    );
    if (fitted && this.#library.current === current) this.#library.takeFitted(uses, fitted);
  }
}
