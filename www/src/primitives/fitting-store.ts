// The couplings of the walking combination, fitted to a clip with fixed primitives.
import type { ClipsStore } from "../clips/clips-store";
import { LARGEST_COUPLING } from "../engine/limits";
import type { Fitted } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import type { LibraryStore } from "./library-store";
import { ProgressStore } from "../training/progress-store";

const MOST_ITERATIONS = 100;

const isLargest = (alpha: number) => alpha > 0.999 * LARGEST_COUPLING;

export class FittingStore extends ProgressStore<Fitted> {
  #unexplained: readonly string[] = [];

  constructor(
    private readonly whole: WholeWorkers,
    private readonly clips: Pick<ClipsStore, "all">,
    private readonly library: LibraryStore,
  ) {
    super();
  }

  /**
   * The parts that the last fit found no coupling for: all predictions about the part got the largest
   * variance.
   */
  get unexplained(): readonly string[] {
    return this.#unexplained;
  }

  /** Fits to the clip of this key, and sets the sliders to the result. */
  async fit(key: string): Promise<void> {
    const clip = this.clips.all.find((clip) => clip.key === key);
    const { current, uses } = this.library;
    if (!clip || !current) return;
    const { loaded, source, first, end } = clip;
    const job = {
      library: current.text,
      uses: [...uses],
      clips: [{ id: loaded.id, source, first, end }],
      maxIterations: MOST_ITERATIONS,
    };
    this.#unexplained = [];
    const fitted = await this.run((report, signal) =>
      this.whole.pool.run((worker) => worker.fitCouplings(job, report, signal), signal),
    );
    if (!fitted || this.library.current !== current) return;
    const atLimit = (part: number) => fitted.alpha.every((row) => isLargest(row[part] ?? 0));
    this.#unexplained = current.info.parts.filter((_, part) => atLimit(part)).map(({ name }) => name);
    this.library.takeFitted(uses, fitted);
    this.changed();
  }
}
