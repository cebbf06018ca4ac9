// Couplings of the combination that walks, fitted to a clip while the primitives stay as they are.
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

  /** Fits to the clip of this key; the sliders take over what was found. */
  async fit(key: string): Promise<void> {
    const clip = this.#clips.all.find((clip) => clip.key === key);
    const { known, uses } = this.#library;
    if (!clip || !known) return;
    const { loaded, source, first, end } = clip;
    const job = {
      library: known.text,
      uses: [...uses],
      clips: [{ id: loaded.id, source, first, end }],
      maxIterations: MOST_ITERATIONS,
    };
    const fitted = await this.run((report, signal) =>
      this.#whole.pool.run((worker) => worker.fitCouplings(job, report, signal), signal),
    );
    if (fitted && this.#library.known === known) this.#library.takeFitted(uses, fitted);
  }
}
