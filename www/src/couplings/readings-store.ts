// Two figures side by side: the same couplings in both readings.
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { Reading, RolloutResult } from "../engine/protocol";
import type { StageStore } from "../stage/stage-store";
import { Store } from "../ui/store";
import type { ModelStore } from "./model-store";
import { lab } from "../words/lab";

/** From left to right. */
const READINGS: readonly Reading[] = ["as-learned", "re-inferred"];

export class ReadingsStore extends Store {
  readonly #latest: Latest<RolloutResult, RolloutResult | null>;
  #bothShown = false;
  /** The last motion whose other reading was asked for. */
  #asked: RolloutResult | null = null;

  constructor(
    engine: EngineStore,
    private readonly model: ModelStore,
    private readonly stage: StageStore,
  ) {
    super();
    this.#latest = new Latest(
      async ({ request }) =>
        (await engine.engine?.rollout({ ...request, reading: otherThan(request.reading) })) ?? null,
      (other, rollout) => this.#take(other, rollout),
      // The figure in the chosen reading walks on alone.
      () => this.show(false),
    );
    model.on(() => this.#follow());
    stage.on(() => {
      // A live motion has a clock of its own.
      if (this.#bothShown && stage.content?.live) this.show(false);
    });
  }

  /** Whether both readings are shown. */
  get bothShown(): boolean {
    return this.#bothShown;
  }

  show(both: boolean): void {
    this.#bothShown = both;
    this.#asked = null;
    if (both) {
      this.stage.endClip();
      this.stage.endLive();
      this.#follow();
    } else {
      this.#latest.drop();
      this.stage.setColumns(null);
    }
    this.changed();
  }

  #follow(): void {
    const { rollout } = this.model;
    if (!this.#bothShown || !rollout || rollout === this.#asked) return;
    const before = this.#asked;
    this.#asked = rollout;
    // Another model has another body.
    if (rollout.revision !== before?.revision) this.stage.setColumns(null);
    // Under the learned couplings both readings are the same.
    if (!rollout.request.alpha) this.#show(rollout, rollout);
    else this.#latest.request(rollout);
  }

  #take(other: RolloutResult | null, rollout: RolloutResult): void {
    // For changed couplings another answer is under way.
    if (this.#bothShown && other && rollout === this.model.rollout) this.#show(rollout, other);
  }

  #show(rollout: RolloutResult, other: RolloutResult): void {
    const columns = READINGS.map((reading) => ({
      title: lab().readings.experts(lab().readings.text[reading]),
      motion: (rollout.request.reading === reading ? rollout : other).motion,
    }));
    this.stage.setColumns(columns);
  }
}

function otherThan(reading: Reading): Reading {
  return reading === "as-learned" ? "re-inferred" : "as-learned";
}
