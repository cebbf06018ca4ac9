// How the rollout on the stage ends: whether it still is a motion. Asked for each rollout that stays for a moment.
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { BodyReport, Health, RolloutResult } from "../engine/protocol";
import { Store } from "../ui/store";
import type { ModelStore } from "./model-store";

/** Milliseconds that a rollout stays before it is looked at: a slider that moves is not kept waiting. */
const CALM = 250;

export class HealthStore extends Store {
  readonly #model: ModelStore;
  readonly #reports: Latest<RolloutResult, BodyReport>;
  #seen: RolloutResult | null = null;
  #health: Health | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    engine: EngineStore,
    model: ModelStore,
    private readonly calm = CALM,
  ) {
    super();
    this.#model = model;
    this.#reports = new Latest(
      ({ request }: RolloutResult) => {
        if (!engine.engine) throw new Error("The model cannot run in this browser.");
        return engine.engine.bodyReport(request, 0);
      },
      ({ health, revision }, rollout) => {
        // The worker may have taken up another model meanwhile.
        if (rollout === this.#seen && revision === rollout.revision) this.#find(health);
      },
      // Whoever asked for the rollout says what is wrong.
      () => {},
    );
    model.on(() => this.#look());
  }

  /** How the rollout on the stage ends; null while it is not known. */
  get health(): Health | null {
    return this.#health;
  }

  #look(): void {
    const { rollout } = this.#model;
    if (rollout === this.#seen) return;
    this.#seen = rollout;
    clearTimeout(this.#timer);
    if (this.#health) this.#find(null);
    if (rollout) this.#timer = setTimeout(() => this.#reports.request(rollout), this.calm);
  }

  #find(health: Health | null): void {
    this.#health = health;
    this.changed();
  }
}
