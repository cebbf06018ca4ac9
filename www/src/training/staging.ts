// Puts models of trainings on the stage one after the other, so that worker and page always hold the same
// model.
import type { Keep, ModelStore } from "../couplings/model-store";
import type { TrainedModel } from "../engine/protocol";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import type { Run } from "./runs";
import { lab } from "../words/lab";

/** Milliseconds between two models of a running training. */
const BETWEEN = 1000;

export class Staging {
  /** One model follows the other. */
  #turn: Promise<void> = Promise.resolve();
  #asked = 0;
  #staged: TrainedModel | null = null;
  /** When the last model reached the stage; infinity while one is on its way. */
  #at = -Infinity;

  constructor(
    private readonly model: ModelStore,
    private readonly notices: NoticesStore,
  ) {}

  /** The trained model that reached the stage last. */
  get staged(): TrainedModel | null {
    return this.#staged;
  }

  /** Whether the last model has been on the stage for long enough. */
  get isDue(): boolean {
    return performance.now() - this.#at >= BETWEEN;
  }

  /** The run leaves the list. If its model is on the stage, no list holds that model any more. */
  release({ model }: Run): void {
    if (model && model === this.#staged) this.model.markMadeHere();
  }

  /** Puts the newest model of a run on the stage; of several quick requests only the last. */
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
      await this.model.open(model.text, keep, model.latents);
      this.#staged = model;
    } catch (problem) {
      this.notices.addError(lab().learn.training.notTakenUp(run.settings.seed), messageOf(problem));
    }
  }
}
