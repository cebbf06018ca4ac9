// The predictions of each part about each part in the rollout on the stage, and their products.
import type { ModelStore } from "../couplings/model-store";
import { sameTimes } from "../couplings/weights";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { PredictionsReport, RolloutRequest, RolloutResult } from "../engine/protocol";
import { Store } from "../ui/store";

/** Milliseconds without a new rollout before the request: a dragged slider needs its rollouts first. */
const QUIET = 80;
/** Milliseconds after which the request is sent anyway, so that predictions follow a dragged slider. */
const LONGEST = 300;

export class PredictionsStore extends Store {
  readonly #model: ModelStore;
  readonly #reports: Latest<RolloutRequest, PredictionsReport | null>;
  #visible = true;
  #report: PredictionsReport | null = null;
  /** The last rollout whose predictions were asked for, or will be. */
  #asked: RolloutResult | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The time since which a request waits. */
  #since: number | null = null;

  constructor(engine: EngineStore, model: ModelStore) {
    super();
    this.#model = model;
    this.#reports = new Latest(
      async (request) => (await engine.engine?.predictions(request)) ?? null,
      (report) => this.#take(report),
      // A model whose predictions cannot be computed still rolls out.
      () => this.#take(null),
    );
    model.on(() => this.#follow());
  }

  get visible(): boolean {
    return this.#visible;
  }

  /**
   * The predictions of the rollout on the stage, or of the rollout before while a coupling moves; null before
   * they have arrived, and while they are hidden.
   */
  get report(): PredictionsReport | null {
    return this.#report;
  }

  show(visible: boolean): void {
    this.#visible = visible;
    if (visible) this.#follow();
    else this.#forget();
    this.changed();
  }

  #follow(): void {
    const { rollout } = this.#model;
    if (rollout === this.#asked || !this.#visible) return;
    this.#asked = rollout;
    if (this.#report && !this.#fits(this.#report)) this.#take(null);
    clearTimeout(this.#timer);
    if (!rollout) return;
    const now = performance.now();
    this.#since ??= now;
    this.#timer = setTimeout(
      () => this.#ask(rollout.request),
      Math.max(0, Math.min(QUIET, this.#since + LONGEST - now)),
    );
  }

  #forget(): void {
    clearTimeout(this.#timer);
    this.#reports.drop();
    [this.#asked, this.#since, this.#report] = [null, null, null];
  }

  #ask(request: RolloutRequest): void {
    this.#since = null;
    this.#reports.request(request);
  }

  #fits({ revision, request }: PredictionsReport): boolean {
    const { rollout } = this.#model;
    return rollout !== null && revision === rollout.revision && sameTimes(request, rollout.request);
  }

  #take(report: PredictionsReport | null): void {
    this.#report = report && this.#fits(report) ? report : null;
    this.changed();
  }
}
