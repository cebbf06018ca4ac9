// The same couplings in both readings, on two figures side by side, while the visitor asks for it.
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { Reading, RolloutResult } from "../engine/protocol";
import type { StageStore } from "../stage/stage-store";
import { Store } from "../ui/store";
import type { ModelStore } from "./model-store";

/** From left to right. */
const READINGS: readonly Reading[] = ["as learned", "re-inferred"];

export class ReadingsStore extends Store {
  readonly #model: ModelStore;
  readonly #stage: StageStore;
  readonly #latest: Latest<RolloutResult, RolloutResult | null>;
  #isBeside = false;
  /** The motion whose other reading was asked for last. */
  #asked: RolloutResult | null = null;

  constructor(engine: EngineStore, model: ModelStore, stage: StageStore) {
    super();
    this.#model = model;
    this.#stage = stage;
    this.#latest = new Latest(
      async ({ request }) =>
        (await engine.engine?.rollout({ ...request, reading: otherThan(request.reading) })) ?? null,
      (other, rollout) => this.#take(other, rollout),
      // The motion in the reading that is chosen walks on alone.
      () => this.show(false),
    );
    model.on(() => this.#follow());
    stage.on(() => {
      // A live motion has a clock of its own.
      if (this.#isBeside && stage.shown?.live) this.show(false);
    });
  }

  /** Whether two figures are asked for. */
  get isBeside(): boolean {
    return this.#isBeside;
  }

  show(beside: boolean): void {
    this.#isBeside = beside;
    this.#asked = null;
    if (beside) {
      this.#stage.endClip();
      this.#stage.endLive();
      this.#follow();
    } else {
      this.#latest.drop();
      this.#stage.setColumns(null);
    }
    this.changed();
  }

  #follow(): void {
    const { rollout } = this.#model;
    if (!this.#isBeside || !rollout || rollout === this.#asked) return;
    const before = this.#asked;
    this.#asked = rollout;
    // Those of another model have another body.
    if (rollout.revision !== before?.revision) this.#stage.setColumns(null);
    // Under the learned couplings both readings are the same.
    if (!rollout.request.alpha) this.#show(rollout, rollout);
    else this.#latest.request(rollout);
  }

  #take(other: RolloutResult | null, rollout: RolloutResult): void {
    // The couplings may have changed meanwhile: then the other reading of these is under way.
    if (this.#isBeside && other && rollout === this.#model.rollout) this.#show(rollout, other);
  }

  #show(rollout: RolloutResult, other: RolloutResult): void {
    const columns = READINGS.map((reading) => ({
      title: `Experts ${reading}`,
      motion: (rollout.request.reading === reading ? rollout : other).motion,
    }));
    this.#stage.setColumns(columns);
  }
}

function otherThan(reading: Reading): Reading {
  return reading === "as learned" ? "re-inferred" : "as learned";
}
