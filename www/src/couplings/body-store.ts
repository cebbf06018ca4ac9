// Measures of the motion under the couplings now and as learned. They are computed a moment after the motion
// has arrived, so that no slider waits for them.
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { BodyReport, RolloutRequest, RolloutResult } from "../engine/protocol";
import { Store } from "../ui/store";
import type { ModelStore } from "./model-store";
import { sameTimes } from "./weights";

/** Seconds of motion, and the first of them that the measures leave out, as in docs/couplings.md. */
const MEASURED = 20;
const SETTLING = 5;

/** Milliseconds after the last motion. Nothing is measured while a slider is dragged. */
const PAUSE = 150;

export interface BodyReports {
  now: BodyReport;
  learned: BodyReport;
}

interface Question {
  rollout: RolloutResult;
  now: RolloutRequest;
  learned: RolloutRequest;
  first: number;
}

export class BodyStore extends Store {
  readonly #latest: Latest<Question, BodyReports | null>;
  #reports: BodyReports | null = null;
  #learned: BodyReport | null = null;
  /** The last motion whose measures were asked for. */
  #asked: RolloutResult | null = null;
  /** The motion whose measures arrived last. */
  #measured: RolloutResult | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    engine: EngineStore,
    private readonly model: ModelStore,
  ) {
    super();
    this.#latest = new Latest(
      async ({ now, learned, first }) => {
        if (!engine.engine) return null;
        const { engine: running } = engine;
        if (!this.#isOf(this.#learned, learned)) this.#learned = await running.bodyReport(learned, first);
        return {
          learned: this.#learned,
          now: now.alpha || now.sample ? await running.bodyReport(now, first) : this.#learned,
        };
      },
      (reports, question) => this.#take(reports, question),
      // A failed rollout has a notice of its own.
      () => {},
    );
    model.on(() => this.#follow());
  }

  /** The last measures; null before the first. */
  get reports(): BodyReports | null {
    return this.#reports;
  }

  /** Whether the measures belong to the motion under the couplings now. */
  get isCurrent(): boolean {
    const { rollout } = this.model;
    return (
      rollout !== null && rollout === this.#measured && same(rollout.request, this.model.rolloutRequest())
    );
  }

  #isOf(report: BodyReport | null, request: RolloutRequest): report is BodyReport {
    return (
      report?.revision === this.model.model?.revision && report !== null && sameTimes(report.request, request)
    );
  }

  #follow(): void {
    const { rollout } = this.model;
    if (rollout === this.#asked) return;
    this.#asked = rollout;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#ask(), PAUSE);
    this.changed();
  }

  #ask(): void {
    const { rollout, model } = this.model;
    if (!rollout || !model) return;
    const frames = (seconds: number) => Math.round(seconds / model.info.frameTime);
    const now = { ...rollout.request, frames: Math.max(rollout.request.frames, frames(MEASURED)) };
    const { sample: _, ...mean } = now;
    const learned: RolloutRequest = { ...mean, alpha: null, reading: "as-learned" };
    this.#latest.request({ rollout, now, learned, first: frames(SETTLING) });
  }

  #take(reports: BodyReports | null, { rollout }: Question): void {
    if (!reports || reports.now.revision !== this.model.model?.revision) return;
    this.#reports = reports;
    this.#measured = rollout;
    this.changed();
  }
}

function same(a: RolloutRequest, b: RolloutRequest): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
