// The phase of each part of the motion on the stage, its period, and whether the parts keep step.
import type { ModelInfo, RolloutResult } from "../engine/protocol";
import type { LiveTrack } from "../scene/live-track";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { Store } from "../ui/store";
import type { BodyStore } from "./body-store";
import { LearnedCycle } from "./learned-cycle";
import { isSwinging, type Step, stepOf } from "./measures-text";
import type { ModelStore } from "./model-store";
import { PhaseTrace } from "./phase-trace";

/** Seconds of a live motion in which its periods and its step are measured. */
const STORED = 8;
const STEP_SECONDS = 4;

export class PhasesStore extends Store {
  #cycles: readonly LearnedCycle[] = [];
  /** The learned motion and the periods that the cycles were made of. */
  #cyclesOf: { learned: RolloutResult; periods: string } | null = null;
  /** The phases of the rollout, and of the live motion. */
  #rolled: { rollout: RolloutResult; trace: PhaseTrace } | null = null;
  #followed: { track: LiveTrack; trace: PhaseTrace } | null = null;

  constructor(
    private readonly model: ModelStore,
    private readonly body: BodyStore,
    private readonly stage: StageStore,
    private readonly playback: Playback,
  ) {
    super();
    const follow = () => this.#follow();
    model.on(follow);
    body.on(follow);
    stage.on(follow);
  }

  /** The parts of the model; none while the stage shows a clip, or if the learned motion is not periodic. */
  get parts(): readonly { name: string }[] {
    return this.#trace() ? (this.model.model?.info.parts ?? []) : [];
  }

  /** Whether the motion is live. Then `periods` and `step` change with time. */
  get isLive(): boolean {
    return this.stage.live !== null;
  }

  /** The turns of a part at the time of the stage. Parts in step as learned have the same turns. */
  turns(part: number): number {
    return this.#trace()?.turns(part, this.playback.frame) ?? 0;
  }

  /** The distance of a part from its learned cycle at the time of the stage, in radii of the cycle. */
  distance(part: number): number {
    return this.#trace()?.distance(part, this.playback.frame) ?? 0;
  }

  /**
   * Seconds of a part's period; "still": it does not move on; null: not yet measured, or no steady pace. For a rollout the
   * library measures hands and feet; for a live motion it is the mean of the last two turns.
   */
  period(part: number): number | "still" | null {
    const trace = this.#trace();
    if (this.isLive) {
      if (trace?.isStanding(part)) return "still";
      const frames = trace?.period(part) ?? null;
      return frames === null ? null : frames * this.#frameTime;
    }
    const { reports } = this.body;
    const now = reports?.now.measures.parts[part];
    const learned = reports?.learned.measures.parts[part];
    if (!now || !learned) return null;
    return isSwinging(now, learned) ? now.period : "still";
  }

  /** How the parts keep step: the least of all parts; null if not yet measured, or if a part has no period. */
  get step(): Step | null {
    const parts = [...this.parts.keys()];
    if (parts.length < 2 || parts.some((part) => typeof this.period(part) !== "number")) return null;
    const frames = Math.round(STEP_SECONDS / this.#frameTime);
    const lockings = this.isLive
      ? parts.slice(1).map((part) => this.#trace()?.locking(part, frames) ?? null)
      : (this.body.reports?.now.measures.parts.map(({ locking }) => locking) ?? []);
    const measured = lockings.filter((locking) => locking !== null);
    return measured.length > 0 ? stepOf(Math.min(...measured)) : null;
  }

  /** Whether the measures belong to the motion under the couplings now. */
  get isCurrent(): boolean {
    return this.isLive || this.body.isCurrent;
  }

  get #frameTime(): number {
    return this.model.model?.info.frameTime ?? 1 / 30;
  }

  /** The phases of the motion on the stage, up to its newest frame. */
  #trace(): PhaseTrace | null {
    if (this.stage.content?.kind !== "model") return null;
    const { live } = this.stage;
    if (!live) return this.#rolled?.trace ?? null;
    if (this.#followed?.track !== live) this.#followLive(live);
    const trace = this.#followed?.trace ?? null;
    if (trace) this.#catchUp(trace, live);
    return trace;
  }

  #followLive(track: LiveTrack): void {
    const frames = Math.ceil(STORED / track.motion.frameTime);
    this.#followed = this.#cycles.length > 0 ? { track, trace: new PhaseTrace(this.#cycles, frames) } : null;
  }

  #catchUp(trace: PhaseTrace, track: LiveTrack): void {
    for (let frame = Math.max(track.first, trace.last + 1); frame <= track.last; frame++)
      trace.add(frame, track.paths, frame - track.first);
  }

  #follow(): void {
    const { model, learned, rollout } = this.model;
    this.#makeCycles(model?.info ?? null, learned);
    if (!rollout || this.#cycles.length === 0) this.#rolled = null;
    else if (this.#rolled?.rollout !== rollout) {
      const trace = new PhaseTrace(this.#cycles, rollout.motion.frames);
      for (let frame = 0; frame < rollout.motion.frames; frame++) trace.add(frame, rollout.latents, frame);
      this.#rolled = { rollout, trace };
    }
    this.changed();
  }

  /** The cycle of each part, from the learned motion and the periods that the library measures in it. */
  #makeCycles(info: ModelInfo | null, learned: RolloutResult | null): void {
    const report = this.body.reports?.learned ?? null;
    if (!info || !learned || report?.revision !== learned.revision) {
      this.#setCycles([], null);
      return;
    }
    const periods = report.measures.parts.map(({ period }) => period);
    const [common] = periods.filter((period) => period !== null);
    const key = periods.join(" ");
    if (this.#cyclesOf?.learned === learned && this.#cyclesOf.periods === key) return;
    // A part without hand or foot has the period of the others.
    const cycles = info.parts.map(({ latent }, part) => {
      const frames = (periods[part] ?? common ?? 0) / info.frameTime;
      return LearnedCycle.from(learned.latents[part] ?? new Float64Array(), latent, info.order, frames);
    });
    const found = cycles.filter((cycle) => cycle !== null);
    this.#setCycles(found.length === cycles.length ? found : [], { learned, periods: key });
  }

  #setCycles(cycles: readonly LearnedCycle[], madeOf: { learned: RolloutResult; periods: string } | null) {
    this.#cycles = cycles;
    this.#cyclesOf = madeOf;
    this.#rolled = null;
    this.#followed = null;
  }
}
