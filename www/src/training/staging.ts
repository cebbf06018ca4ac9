// Takes models of trainings up on the stage, one after the other, so that worker and page always hold the
// same model.
import type { Keep, ModelStore } from "../couplings/model-store";
import type { TrainedModel } from "../engine/protocol";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import type { Run } from "./runs";

/** Milliseconds between two models of trainings under way. */
const BETWEEN = 1000;

export class Staging {
  readonly #model: ModelStore;
  readonly #notices: NoticesStore;
  /** What is taken up now; the next waits for it. */
  #turn: Promise<void> = Promise.resolve();
  #asked = 0;
  #staged: TrainedModel | null = null;
  /** When the last was taken up; infinity while one is. */
  #at = -Infinity;

  constructor(model: ModelStore, notices: NoticesStore) {
    this.#model = model;
    this.#notices = notices;
  }

  /** The trained model that was taken up last. */
  get staged(): TrainedModel | null {
    return this.#staged;
  }

  /** Whether the last one has been on the stage for long enough. */
  get isDue(): boolean {
    return performance.now() - this.#at >= BETWEEN;
  }

  /** The run leaves the list: where its model is on the stage, nothing else holds it. */
  letGo({ model }: Run): void {
    if (model && model === this.#staged) this.#model.markMadeHere();
  }

  /** Takes the newest model of a run up; of several asked for in quick succession only the last. */
  stage(run: Run, keep?: Keep): Promise<void> {
    this.#asked += 1;
    const asked = this.#asked;
    const { model } = run;
    this.#at = Infinity;
    this.#turn = this.#turn.then(async () => {
      if (asked !== this.#asked) return;
      if (model) await this.#takeUp(run, model, keep);
      if (asked === this.#asked) this.#at = performance.now();
    });
    return this.#turn;
  }

  async #takeUp(run: Run, model: TrainedModel, keep?: Keep): Promise<void> {
    try {
      await this.#model.open(model.text, keep, model.latents);
      this.#staged = model;
    } catch (problem) {
      this.#notices.addError(`The model of seed ${run.settings.seed} was not taken up`, messageOf(problem));
    }
  }
}
