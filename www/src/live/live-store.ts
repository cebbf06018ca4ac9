// The live rollout: the model continues from the figure's state, while couplings are cut, and parts are pushed
// or moved by a hand or a recording.
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { Engine, LiveChange, LiveFrames, ModelInfo, Motion } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { LONGEST_PICTURE } from "../ui/browser";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { withLab } from "../words/lab";

/** Seconds that are stored, and shown in the strip chart. */
export const SHOWN_SECONDS = 12;
/** Frames computed ahead of the clock. Actions of the visitor are visible this much later. */
const LEAD = 3;
/** The same while the visitor moves a part: at most one frame is ahead, which a change replaces. */
const DRIVEN_LEAD = 0;
/**
 * The measure from a turn of the wheel, or a move of a dragged node, to the arrival of the first frame that obeys
 * it; `npm run alpha` reads it.
 */
const HAND_MEASURE = "hand-answer";

/** What moves a part in place of the model, in frames from the start. */
export type MoverMark =
  /** The visitor at the wheel. */
  | { kind: "drive"; part: number; from: number; to: number | null }
  | { kind: "record"; part: number; key: string; title: string; from: number; to: number | null }
  /**
   * The visitor drags a node, or pushes the part. `began` is the first frame of the push, `from` its last;
   * `held`: it goes on.
   */
  | { kind: "push"; part: number; began: number; from: number; held?: boolean };

/** An action of the visitor, in frames from the start. */
export type Mark =
  | { kind: "cut"; source: number; target: number; from: number; to: number | null }
  | MoverMark;

/** A recording that moves one part. */
export interface RecordedPart {
  key: string;
  title: string;
  /** The latents of the part in all frames [frames x Q]. */
  latents: Float64Array;
  motion: Motion;
}

/** The phases and distances of one frame. */
export interface TracePoint {
  frame: number;
  /** The phase of each part on the learned cycle, in turns; empty without a cycle. */
  phases: readonly number[];
  /** The distance of each part from its cycle, in radii of the cycle. */
  distances: readonly number[];
}

export class LiveStore extends Store {
  #track: LiveTrack | null = null;
  #starting = false;
  #trace: TracePoint[] = [];
  #marks: Mark[] = [];
  readonly #cuts = new Map<string, Extract<Mark, { kind: "cut" }>>();
  /** The parts that the model does not move now. */
  readonly #movers = new Map<number, MoverMark>();
  /** The recordings that move parts; the newest one is the outline. */
  readonly #recordings = new Map<number, Motion>();
  /** Changes for the next frames. */
  #changes: LiveChange[] = [];
  #busy = false;
  /** The time of the last request for frames. */
  #askedAt = 0;
  /** The time of the first turn of the wheel, or move of a dragged node, that no frame obeys; null without one. */
  #movedAt: number | null = null;
  /** The couplings and the model of the worker. */
  #sent: LiveChange | null = null;
  #revision = 0;

  constructor(
    private readonly engine: EngineStore,
    private readonly settings: SettingsStore,
    private readonly model: ModelStore,
    private readonly stage: StageStore,
    private readonly playback: Playback,
    private readonly notices: NoticesStore,
  ) {
    super();
    playback.on(() => void this.#fill());
    model.on(() => this.#followCouplings());
    stage.on(() => {
      // A clip or both readings are in front.
      if (!stage.content?.live) this.stop();
    });
  }

  get running(): boolean {
    return this.#track !== null;
  }

  get track(): LiveTrack | null {
    return this.#track;
  }

  get trace(): readonly TracePoint[] {
    return this.#trace;
  }

  get marks(): readonly Mark[] {
    return this.#marks;
  }

  isCut(source: number, target: number): boolean {
    return this.#cuts.has(`${source}.${target}`);
  }

  /** Starts at the state of the figure. */
  async start(): Promise<void> {
    const { engine } = this.engine;
    if (!engine || this.#track || this.#starting) return;
    this.#starting = true;
    try {
      let track: LiveTrack;
      // A new model from training may have replaced the model: then the new one goes live.
      do {
        const { model } = this.model;
        if (!model) return;
        this.#revision = model.revision;
        track = await this.#begin(engine, model.info);
      } while (this.model.model?.revision !== this.#revision);
      this.#track = track;
      this.stage.showLive(track);
      this.playback.play();
    } catch (problem) {
      withLab(({ live }) => this.notices.addError(live.notBegun, messageOf(problem)));
    } finally {
      this.#starting = false;
    }
    this.changed();
  }

  /** The first frames of this model. */
  async #begin(engine: Engine, { frameTime, figure, parts }: ModelInfo): Promise<LiveTrack> {
    this.stage.endClip();
    const request = this.model.rolloutRequest();
    const frame = Math.min(Math.floor(this.playback.frame), request.frames - 1);
    await engine.startLive(request, frame);
    this.#sent = this.#couplings();
    [this.#trace, this.#marks, this.#changes] = [[], [], []];
    this.#forget();
    const stored = Math.round(SHOWN_SECONDS / frameTime);
    const widths = parts.map(({ latent }) => latent);
    const track = new LiveTrack({ nodes: figure.nodes.length, frameTime }, stored, widths);
    // A rollout under the learned couplings is "as-learned"; a cut obeys the visitor's reading.
    this.#take(track, await engine.advanceLive([this.#sent], LEAD));
    return track;
  }

  /** Back to the motion of some seconds. */
  stop(): void {
    if (!this.#track) return;
    this.#track = null;
    this.#forget();
    this.stage.endLive();
    void this.engine.engine?.endLive();
    this.changed();
  }

  #forget(): void {
    for (const all of [this.#cuts, this.#movers, this.#recordings]) all.clear();
    this.#movedAt = null;
  }

  /** Cuts a coupling for as long as it is held. */
  async hold(source: number, target: number, held: boolean): Promise<void> {
    const key = `${source}.${target}`;
    if (held === this.#cuts.has(key)) return;
    if (held) await this.start();
    if (!this.#track) return;
    const from = this.#next;
    if (held) {
      const others = this.model.model?.info.parts.some(
        (_, other) => other !== source && !this.isCut(other, target),
      );
      if (!others) {
        withLab(({ live }) => this.notices.addError(live.stays, live.staysWhy));
        return;
      }
      const mark = { kind: "cut" as const, source, target, from, to: null };
      this.#cuts.set(key, mark);
      this.#marks.push(mark);
    } else {
      const mark = this.#cuts.get(key);
      if (mark) mark.to = from;
      this.#cuts.delete(key);
    }
    this.#changes.push({ kind: "cut", source, target, cut: held });
    this.changed();
  }

  /** Pushes the part of a node by metres, in the axes of the stage. */
  pull(node: number, by: readonly [number, number, number]): void {
    if (!this.#track) return;
    this.#changes.push({ kind: "pull", node, by: this.#track.turnedBack(by) });
    this.#markPush(this.#partOf(node));
  }

  /** Lets the part of a node follow the node's place in the picture, shifted by metres, until it is released. */
  reach(node: number, by: readonly [number, number, number]): void {
    const part = this.#partOf(node);
    const { pose } = this.playback;
    if (!this.#track || !pose || part < 0) return;
    const mover = this.#movers.get(part);
    if (mover?.kind !== "push")
      this.#move({ kind: "push", part, began: this.#next, from: this.#next, held: true });
    const fromRoot = (axis: 0 | 1 | 2) => (pose[3 * node + axis] ?? 0) - (pose[axis] ?? 0) + by[axis];
    const place = this.#track.turnedBack([fromRoot(0), fromRoot(1), fromRoot(2)]);
    // Only the newest place matters.
    if (this.#changes.at(-1)?.kind === "reach") this.#changes.pop();
    this.#changes.push({ kind: "reach", node, place });
    this.#movedAt ??= performance.now();
    void this.#fill();
    this.changed();
  }

  /** Shifts a part in each latent dimension. */
  push(part: number, by: number[]): void {
    if (!this.#track) return;
    this.#changes.push({ kind: "push", part, by });
    this.#markPush(part);
  }

  /** What moves a part; null: the model. */
  moverOf(part: number): MoverMark | null {
    return this.#movers.get(part) ?? null;
  }

  /** The part that the visitor drives by the wheel; null without one. */
  get driven(): number | null {
    return [...this.#movers.values()].find(({ kind }) => kind === "drive")?.part ?? null;
  }

  /** Drives a part by turns round its learned cycle. With 0 it stands still. There is one wheel. */
  drive(part: number, turns: number): void {
    if (!this.#track) return;
    const { driven } = this;
    if (driven !== part) {
      if (driven !== null) this.release(driven);
      this.#move({ kind: "drive", part, from: this.#next, to: null });
    }
    if (turns !== 0) this.#movedAt ??= performance.now();
    const last = this.#changes.at(-1);
    if (last?.kind === "drive" && last.part === part) last.turns += turns;
    else this.#changes.push({ kind: "drive", part, turns });
    void this.#fill();
    this.changed();
  }

  /** Lets a recording move a part until it is released, and draws the recording as an outline. */
  record(part: number, { key, title, latents, motion }: RecordedPart): void {
    if (!this.#track) return;
    this.#move({ kind: "record", part, key, title, from: this.#next, to: null });
    this.#changes.push({ kind: "record", part, latents });
    this.#recordings.set(part, motion);
    this.#showRecording();
    this.changed();
  }

  /** Lets the model move a part from where it is. */
  release(part: number): void {
    const mover = this.#movers.get(part);
    if (!mover || !this.#track) return;
    this.#end(mover);
    this.#changes.push({ kind: "release", part });
    this.changed();
  }

  /** Lets go the part of a node that was dragged. */
  letGo(node: number): void {
    const part = this.#partOf(node);
    if (this.#movers.get(part)?.kind === "push") this.release(part);
  }

  /** The next frame. */
  get #next(): number {
    return (this.#track?.last ?? 0) + 1;
  }

  /** Replaces what moves a part. */
  #move(mark: MoverMark): void {
    const before = this.#movers.get(mark.part);
    if (before) this.#end(before);
    this.#movers.set(mark.part, mark);
    this.#marks.push(mark);
    this.playback.play();
  }

  #end(mark: MoverMark): void {
    if (mark.kind === "push") mark.held = false;
    else mark.to = this.#next;
    this.#movers.delete(mark.part);
    if (this.#recordings.delete(mark.part)) this.#showRecording();
  }

  #showRecording(): void {
    this.stage.setRecording([...this.#recordings.values()].at(-1) ?? null);
  }

  #partOf(node: number): number {
    const { model } = this.model;
    const joint = model?.info.figure.nodes[node]?.joint ?? -1;
    return model?.info.parts.findIndex(({ joints }) => joints.includes(joint)) ?? -1;
  }

  #markPush(part: number): void {
    const from = this.#next;
    const last = this.#marks.at(-1);
    // A drag is many small pushes with one mark.
    if (last?.kind === "push" && last.part === part && from - last.from < 10) last.from = from;
    else this.#marks.push({ kind: "push", part, began: from, from });
    this.changed();
  }

  #couplings(): Extract<LiveChange, { kind: "couplings" }> {
    const { alpha, reading } = this.model.couplings;
    return { kind: "couplings", alpha, reading };
  }

  /** Called when the couplings or the model may have changed. */
  #followCouplings(): void {
    if (!this.#track) return;
    if (this.model.model?.revision !== this.#revision) {
      this.stop();
      return;
    }
    const now = this.#couplings();
    if (JSON.stringify(now) === JSON.stringify(this.#sent)) return;
    this.#sent = now;
    // Only the newest couplings matter.
    this.#changes = this.#changes.filter(({ kind }) => kind !== "couplings");
    this.#changes.push(now);
  }

  /** Asks for frames before the clock needs them. */
  async #fill(): Promise<void> {
    const track = this.#track;
    const { engine } = this.engine;
    if (!track || !engine || this.#busy) return;
    // A slow machine, or double speed, needs more frames at once.
    const now = performance.now();
    const seconds = Math.min(LONGEST_PICTURE, (now - this.#askedAt) / 1000);
    this.#askedAt = now;
    const isHeld = [...this.#movers.values()].some(({ kind }) => kind !== "record");
    const lead = isHeld ? DRIVEN_LEAD : LEAD;
    const ahead = lead + (seconds * this.settings.values.speed) / track.motion.frameTime;
    const movedAt = this.#movedAt;
    // A frame that the figure has not reached is computed again, so that the next picture obeys the hand.
    const replaced = movedAt !== null && track.last > this.playback.frame ? 1 : 0;
    const last = track.last - replaced;
    if (movedAt === null && last - this.playback.frame >= ahead) return;
    this.#busy = true;
    const changes: LiveChange[] = replaced > 0 ? [{ kind: "take-back" }, ...this.#changes] : this.#changes;
    [this.#changes, this.#movedAt] = [[], null];
    try {
      const frames = Math.max(1, Math.ceil(ahead + this.playback.frame - last));
      const next = await engine.advanceLive(changes, frames);
      if (this.#track === track) {
        this.#dropAfter(track, last);
        this.#take(track, next);
        this.playback.follow(track);
        if (movedAt !== null) performance.measure(HAND_MEASURE, { start: movedAt });
      }
    } catch (problem) {
      if (this.#track === track) {
        withLab(({ live }) => this.notices.addError(live.ended, messageOf(problem)));
        this.stop();
      }
    } finally {
      this.#busy = false;
    }
    this.changedSoon();
  }

  /** Drops the frames after this one. */
  #dropAfter(track: LiveTrack, last: number): void {
    track.cutAfter(last);
    while ((this.#trace.at(-1)?.frame ?? last) > last) this.#trace.pop();
  }

  #take(track: LiveTrack, { motion, latents, phases, distances, recorded }: LiveFrames): void {
    const before = track.last;
    const parts = latents.length;
    const outlined = [...this.#recordings.keys()].at(-1) ?? 0;
    const frames = Array.from({ length: motion.frames }, (_, k) => recorded[k * parts + outlined] ?? -1);
    track.append(
      motion,
      latents,
      frames.map((frame) => (frame < 0 ? null : frame)),
    );
    for (const mover of this.#movers.values()) if (mover.kind === "push") mover.from = track.last + 1;
    const stored = Math.round(SHOWN_SECONDS / motion.frameTime);
    for (let k = 0; k < motion.frames; k++) {
      const place = (values: Float64Array) => [...values.subarray(k * parts, (k + 1) * parts)];
      this.#trace.push({ frame: before + 1 + k, phases: place(phases), distances: place(distances) });
    }
    if (this.#trace.length > stored) this.#trace.splice(0, this.#trace.length - stored);
    const first = this.#trace[0]?.frame ?? 0;
    this.#marks = this.#marks.filter(
      (mark) => (mark.kind === "push" ? mark.from : (mark.to ?? Infinity)) >= first,
    );
  }
}
