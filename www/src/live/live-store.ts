// A motion without an end, of a model or of a combination of primitives: it continues from the figure's state,
// while couplings, primitives and tempos change, and parts are pushed or moved by a hand or a recording.
import type { LiveBody, LiveChange, LiveFrames, LiveStep, Motion } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import { fromRoot } from "../scene/motion";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { LONGEST_PICTURE } from "../ui/browser";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { withLab } from "../words/lab";
import { type Made, newest } from "./changes";
import { expectedAfter, Transition, TRANSITION_FRAMES } from "./transition";

/** Seconds that are stored, and shown in the strip chart. */
export const SHOWN_SECONDS = 12;
/** Frames computed ahead of the clock. After an action of the visitor they are computed again. */
const LEAD = 3;
/** The same while the visitor moves a part: a turn of the wheel is visible in the next frame as a whole. */
const DRIVEN_LEAD = 0;
/**
 * The measure from a turn of the wheel, or a move of a dragged node, to the arrival of the first frame that obeys
 * it; `npm run alpha` reads it.
 */
const HAND_MEASURE = "hand-answer";

/** What moves a part in place of the model, in frames from the start. */
export type MoverMark =
  /** The visitor at the wheel, or stepping. */
  | { kind: "drive"; part: number; byFeet?: boolean; from: number; to: number | null }
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

/** Who computes a live motion. */
export interface LiveSource {
  /** Null: nothing can move yet. */
  readonly body: LiveBody | null;
  /** Changes with the model: its live motion ends then. */
  readonly revision: number;
  /** The couplings that the motion follows; null: changes of them are told. */
  readonly couplings: LiveChange | null;
  on(listener: () => void): () => void;
  /** Begins at the state of the figure. */
  begin(): Promise<void>;
  advance(step: LiveStep): Promise<LiveFrames>;
  end(): void;
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
  /** Changes in frames that may be computed again. */
  #made: Made[] = [];
  /** The last frame that the clock has reached. */
  #seen = 0;
  /** Whether a change would make the figure jump. */
  #leaps = false;
  #transition = new Transition();
  #busy = false;
  /** The time of the last request for frames. */
  #askedAt = 0;
  /** The time of the first turn of the wheel, or move of a dragged node, that no frame obeys; null without one. */
  #movedAt: number | null = null;
  /** The couplings and the model of the worker. */
  #sent: LiveChange | null = null;
  #revision = -1;

  constructor(
    private readonly source: LiveSource,
    private readonly stage: StageStore,
    private readonly playback: Playback,
    private readonly notices: NoticesStore,
  ) {
    super();
    playback.on(() => this.#follow());
    source.on(() => this.#followSource());
    stage.on(() => {
      // A clip or both readings are in front.
      if (!stage.content?.live) this.stop();
    });
  }

  get body(): LiveBody | null {
    return this.source.body;
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

  /** Whether the parts have phases on a learned cycle. */
  get isCyclic(): boolean {
    return (this.#trace.at(-1)?.phases.length ?? 0) > 0;
  }

  get marks(): readonly Mark[] {
    return this.#marks;
  }

  isCut(source: number, target: number): boolean {
    return this.#cuts.has(`${source}.${target}`);
  }

  /** Starts at the state of the figure. */
  async start(): Promise<void> {
    if (!this.source.body || this.#track || this.#starting) return;
    this.#starting = true;
    try {
      let track: LiveTrack;
      // Another model may have replaced the model: then the new one goes live.
      do {
        const { body, revision } = this.source;
        if (!body) return;
        this.#revision = revision;
        track = await this.#begin(body);
      } while (this.source.revision !== this.#revision);
      this.#track = track;
      this.stage.showLive(track);
      this.playback.play();
      if (this.#changes.length > 0) this.#fillSoon();
    } catch (problem) {
      withLab(({ live }) => this.notices.addError(live.notBegun, messageOf(problem)));
    } finally {
      this.#starting = false;
    }
    this.changed();
  }

  /** The first frames. */
  async #begin({ frameTime, figure, parts }: LiveBody): Promise<LiveTrack> {
    this.stage.endClip();
    // A change that comes while the motion begins is not lost.
    this.#changes = [];
    await this.source.begin();
    this.#sent = this.source.couplings;
    [this.#trace, this.#marks, this.#made] = [[], [], []];
    [this.#seen, this.#leaps, this.#transition] = [0, false, new Transition()];
    this.#forget();
    const stored = Math.round(SHOWN_SECONDS / frameTime);
    // A rollout under the learned couplings is "as-learned"; a cut obeys the visitor's reading.
    const changes = this.#sent ? [this.#sent] : [];
    const first = await this.source.advance({ back: 0, changes, frames: LEAD });
    // After the latents of the parts, the columns.
    const widths = [...parts.map(({ latent }) => latent), first.columns.length / LEAD];
    const track = new LiveTrack({ nodes: figure.nodes.length, frameTime }, stored, widths);
    this.#append(track, first);
    return track;
  }

  /** Back to the motion of some seconds. */
  stop(): void {
    if (!this.#track) return;
    this.#track = null;
    this.#forget();
    this.stage.endLive();
    this.source.end();
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
      const others = this.source.body?.parts.some(
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
    this.change({ kind: "cut", source, target, cut: held });
    this.changed();
  }

  /** Acts from the next frame on that was not shown. `leaps`: the change is large, not a step of a slider. */
  change(change: LiveChange, leaps = change.kind === "use"): void {
    if (!this.#track && !this.#starting) return;
    this.#leaps ||= leaps;
    this.#changes.push(change);
    if (this.#track) this.#fillSoon();
  }

  /** Pushes the part of a node by metres, in the axes of the stage. */
  pull(node: number, by: readonly [number, number, number]): void {
    if (!this.#track) return;
    this.change({ kind: "pull", node, by: this.#track.turnedBack(by) });
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
    const place = this.#track.turnedBack(fromRoot(pose, node, by));
    this.#changes.push({ kind: "reach", node, place });
    this.#movedAt ??= performance.now();
    void this.#fill();
    this.changed();
  }

  /** Shifts a part in each latent dimension. */
  push(part: number, by: number[]): void {
    if (!this.#track) return;
    this.change({ kind: "push", part, by });
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

  /**
   * Drives a part by turns round its learned cycle, with the wheel or by feet. With 0 it stands still. There is one
   * wheel.
   */
  drive(part: number, turns: number, byFeet = false): void {
    if (!this.#track) return;
    const { driven } = this;
    if (driven !== part) {
      if (driven !== null) this.release(driven);
      this.#move({ kind: "drive", part, byFeet, from: this.#next, to: null });
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
    this.change({ kind: "record", part, latents });
    this.#recordings.set(part, motion);
    this.#showRecording();
    this.changed();
  }

  /** Lets the model move a part from where it is. */
  release(part: number): void {
    const mover = this.#movers.get(part);
    if (!mover || !this.#track) return;
    this.#end(mover);
    this.change({ kind: "release", part });
    this.changed();
  }

  /** Lets go the part of a node that was dragged. */
  letGo(node: number): void {
    const part = this.#partOf(node);
    if (this.#movers.get(part)?.kind === "push") this.release(part);
  }

  /** The last frame that does not change. A paused figure is between two frames, which both stay. */
  get #lastUnchanged(): number {
    const seen = this.playback.playing ? Math.floor(this.#seen) : Math.ceil(this.#seen);
    return Math.min(seen, this.#track?.last ?? 0);
  }

  /** The first frame that an action changes. */
  get #next(): number {
    return this.#lastUnchanged + 1;
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
    const { body } = this.source;
    const joint = body?.figure.nodes[node]?.joint ?? -1;
    return body?.parts.findIndex(({ joints }) => joints.includes(joint)) ?? -1;
  }

  #markPush(part: number): void {
    const from = this.#next;
    const last = this.#marks.at(-1);
    // A drag is many small pushes with one mark.
    if (last?.kind === "push" && last.part === part && from - last.from < 10) last.from = from;
    else this.#marks.push({ kind: "push", part, began: from, from });
    this.changed();
  }

  /** Called when the couplings or the model may have changed. */
  #followSource(): void {
    if (!this.#track) return;
    if (this.source.revision !== this.#revision) {
      this.stop();
      return;
    }
    const now = this.source.couplings;
    if (!now || JSON.stringify(now) === JSON.stringify(this.#sent)) return;
    this.#sent = now;
    this.change(now);
  }

  /** Called when the clock has moved. */
  #follow(): void {
    if (!this.#track) return;
    this.#seen = Math.max(this.#seen, this.playback.frame);
    void this.#fill();
  }

  /** Asks for frames after all changes of this moment. */
  #fillSoon(): void {
    queueMicrotask(() => void this.#fill());
  }

  /** Asks for frames before the clock needs them, and after a change again for those that were not shown. */
  async #fill(): Promise<void> {
    const track = this.#track;
    if (!track || this.#busy) return;
    const { frame, playing, speed } = this.playback;
    // A slow machine, or double speed, needs more frames at once.
    const now = performance.now();
    const seconds = Math.min(LONGEST_PICTURE, (now - this.#askedAt) / 1000);
    this.#askedAt = now;
    const isHeld = [...this.#movers.values()].some(({ kind }) => kind !== "record");
    const lead = isHeld ? DRIVEN_LEAD : LEAD;
    // A paused figure moves on to the end of the transition, so that the change is visible.
    const onward = this.#leaps && !playing ? TRANSITION_FRAMES : 0;
    const ahead = lead + onward + (seconds * speed) / track.motion.frameTime;
    const isChanged = this.#changes.length > 0;
    const from = isChanged ? this.#lastUnchanged : track.last;
    if (!isChanged && from - frame >= ahead) return;
    const back = track.last - from;
    // A hand that holds a part gives its turns to the next frames alone.
    const frames = Math.max(1, isHeld ? 0 : back, Math.ceil(ahead + frame - from));
    const [movedAt, leaps] = [this.#movedAt, this.#leaps];
    [this.#busy, this.#movedAt, this.#leaps] = [true, null, false];
    try {
      const next = await this.source.advance({ back, changes: this.#changesAfter(from), frames });
      if (this.#track !== track) return;
      this.#take(track, next, from, leaps);
      this.playback.follow(track);
      if (movedAt !== null) performance.measure(HAND_MEASURE, { start: movedAt });
      if (onward > 0 && !this.playback.playing) this.playback.seek(from + onward);
    } catch (problem) {
      if (this.#track === track) {
        withLab(({ live }) => this.notices.addError(live.ended, messageOf(problem)));
        this.stop();
      }
    } finally {
      this.#busy = false;
      if (this.#changes.length > 0) this.#fillSoon();
    }
    this.changedSoon();
  }

  /** The changes after a frame: those of the frames computed again, and the new ones. */
  #changesAfter(frame: number): LiveChange[] {
    const again = this.#made.filter(({ after }) => after >= frame).flatMap(({ changes }) => changes);
    const changes = newest([...again, ...this.#changes]);
    this.#changes = [];
    const before = this.#made.filter(({ after }) => after >= Math.floor(this.#seen) && after < frame);
    this.#made = [...before, { after: frame, changes }];
    return changes;
  }

  /** Replaces the frames after `from`. */
  #take(track: LiveTrack, next: LiveFrames, from: number, leaps: boolean): void {
    const { positions, frames, nodes } = next.motion;
    const expected = leaps ? expectedAfter(track, from) : null;
    if (expected) this.#transition.start(from + 1, positions.subarray(0, 3 * nodes), expected);
    this.#transition.apply(positions, frames, from + 1);
    track.cutAfter(from);
    while ((this.#trace.at(-1)?.frame ?? from) > from) this.#trace.pop();
    this.#append(track, next);
  }

  #append(track: LiveTrack, { motion, latents, columns, phases, distances, recorded }: LiveFrames): void {
    const before = track.last;
    const parts = latents.length;
    const outlined = [...this.#recordings.keys()].at(-1) ?? 0;
    const frames = Array.from({ length: motion.frames }, (_, k) => recorded[k * parts + outlined] ?? -1);
    track.append(
      motion,
      [...latents, columns],
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
