// What the page knows now, and who wants to hear when it changes. No rendering, no wasm.
import type { Engine, TrainingWorker } from "../engine/engine";
import { Walk } from "../scene/motion";
import type { Pool } from "../engine/pool";
import type {
  ClipSource,
  Couplings,
  Figure,
  InducingPoint,
  InducingReport,
  LoadedClip,
  ModelView,
  Motion,
  PartSpec,
  RolloutRequest,
  RolloutResult,
} from "../engine/protocol";
import { Player } from "../stage/player";
import { type Run, isOver } from "../training/runs";
import type { Settings } from "../settings/settings";

export type Topic =
  | "settings" // a setting changed
  | "engine" // the worker got ready, or cannot
  | "shown" // another motion or figure on the stage
  | "model" // another model
  | "rollout" // another rollout or other couplings
  | "clips"
  | "training" // started, ended, or went on
  | "pointed" // another inducing point is pointed at, or its report came
  | "study" // a comparison of models: begun, ended, or went on
  | "lesson" // the synthetic experiment: another one is looked at, or trainings begun, ended, or went on
  | "notices"
  | "playback" // play, pause, speed, loop
  | "tick"; // the frame now changed

/** What the stage plays. */
export interface Shown {
  /** "first": the stored first seconds; "model": a rollout; "clip": a recording. */
  kind: "first" | "model" | "clip";
  figure: Figure;
  joints: string[];
  parts: PartSpec[];
  motion: Motion;
  /** The key of the clip, when it is one. */
  clip?: string;
}

export interface ClipEntry {
  key: string;
  title: string;
  /** "made": by this project's procedural walker; "own": opened by the visitor. */
  origin: "made" | "own";
  movement: string;
  source: ClipSource;
  loaded: LoadedClip;
  ticked: boolean;
  /** The frames to train on: first up to, not including, end. */
  first: number;
  end: number;
}

export interface Notice {
  id: number;
  kind: "error" | "done";
  title: string;
  text: string;
  /** Where a dropped file landed, in page pixels; null: in the list of clips. */
  at: { x: number; y: number } | null;
}

/** What the last press of Train asked for. */
export interface Training {
  status: "idle" | "running" | "cancelling";
  runs: Run[];
  /** Stops the runs; each keeps its best so far. */
  stop: AbortController;
  /** Kept when each of the runs is over. */
  work: Promise<void>[];
  /** The visitor has chosen a run to look at since it began. */
  picked: boolean;
  /** How it ended, or why it could not start. */
  ending: string;
  failed: boolean;
}

/** Milliseconds between two redraws of what workers report, however many work. */
const TELL_EVERY = 100;

export class App {
  engine: Engine | null = null;
  pool: Pool<TrainingWorker> | null = null;
  engineState: "loading" | "ready" | "failed" = "loading";
  engineProblem = "";
  version = "";

  shown: Shown | null = null;
  walk: Walk | null = null;
  readonly player = new Player();

  model: ModelView | null = null;
  /** The rollout of the model as learned, and under the couplings now. */
  learned: RolloutResult | null = null;
  rollout: RolloutResult | null = null;

  clips: ClipEntry[] = [];
  /** Whether all clips that come with the page are there. */
  samplesLoaded = false;
  /** Why the ticked clips cannot be trained on together; empty when they can. */
  clash = "";
  training: Training = {
    status: "idle",
    runs: [],
    stop: new AbortController(),
    work: [],
    picked: false,
    ending: "",
    failed: false,
  };
  /** The trainings of this visit, until they are cleared. */
  runs: Run[] = [];
  /** The run whose model is on the stage, or will be; null: a model from elsewhere. */
  chosen: Run | null = null;
  pointing: InducingPoint | null = null;
  pointed: InducingReport | null = null;
  notices: Notice[] = [];

  private readonly listeners = new Map<Topic, Set<() => void>>();
  private readonly soon = new Set<Topic>();
  private lastNotice = 0;

  constructor(
    public settings: Settings,
    readonly embedded: boolean,
  ) {
    this.player.speed = settings.speed;
    this.player.loops = settings.loop;
  }

  /** Calls back after each change of these topics; answers how to stop that. */
  on(topics: readonly Topic[], listener: () => void): () => void {
    for (const topic of topics) {
      if (!this.listeners.has(topic)) this.listeners.set(topic, new Set());
      this.listeners.get(topic)!.add(listener);
    }
    return () => topics.forEach((topic) => this.listeners.get(topic)?.delete(listener));
  }

  /** Tells of a topic once in a while, however often this is called: workers report more often than is worth a redraw. */
  tellSoon(topic: Topic): void {
    if (this.soon.has(topic)) return;
    this.soon.add(topic);
    setTimeout(() => {
      this.soon.delete(topic);
      this.tell(topic);
    }, TELL_EVERY);
  }

  tell(...topics: Topic[]): void {
    const told = new Set<() => void>();
    for (const topic of topics) this.listeners.get(topic)?.forEach((listener) => told.add(listener));
    told.forEach((listener) => listener());
  }

  notify(notice: Omit<Notice, "id">): void {
    this.notices = [...this.notices, { ...notice, id: ++this.lastNotice }].slice(-6);
    this.tell("notices");
  }

  /** Takes back what was said about earlier drops. */
  clearNotices(): void {
    if (this.notices.length === 0) return;
    this.notices = [];
    this.tell("notices");
  }

  dismiss(id: number): void {
    this.notices = this.notices.filter((notice) => notice.id !== id);
    this.tell("notices");
  }

  /** Puts a motion on the stage. The same figure goes on from where it stands, at the same time. */
  show(shown: Shown): void {
    // A rollout goes on where the stored first seconds or another rollout is; a clip goes on only as itself.
    const goesOn = this.shown?.clip === shown.clip;
    const sameFigure = this.shown?.motion.nodes === shown.motion.nodes;
    const pose = this.walk && sameFigure ? this.walk.at(this.player.frame).slice() : null;
    if (!goesOn || !sameFigure) this.player.frame = 0;
    this.shown = shown;
    this.walk = new Walk(shown.motion, shown.kind === "clip");
    this.player.load(shown.motion.frames, shown.motion.frameTime, this.walk.loop.end);
    if (pose && goesOn) this.walk.standAt(this.player.frame, pose);
    this.tell("shown", "tick");
  }

  /** Moves the clock on by seconds. */
  advance(seconds: number): void {
    if (!this.player.playing) return;
    const laps = this.player.advance(seconds);
    for (let lap = 0; lap < laps; lap++) this.walk?.lap();
    if (!this.player.playing) this.tell("playback");
    this.tell("tick");
  }

  /** Goes to a frame at once. */
  goTo(frame: number): void {
    this.player.scrub(frame);
    this.walk?.settle();
    this.tell("tick");
  }

  /** alpha[source][target] now; the learned ones where nothing was changed. */
  couplings(): Couplings {
    const learned = this.model?.info.alpha ?? [];
    return learned.map((row, source) =>
      row.map((alpha, target) => this.settings.alpha[`${source}.${target}`] ?? alpha),
    );
  }

  /** Whether the rollout differs from the one as learned. */
  get altered(): boolean {
    return Object.keys(this.settings.alpha).length > 0;
  }

  rolloutRequest(): RolloutRequest {
    const { frames, reading } = this.settings;
    const sequences = this.model?.info.sequences.length ?? 1;
    return {
      frames,
      sequence: Math.min(this.settings.start, Math.max(0, sequences - 1)),
      alpha: this.altered ? this.couplings() : null,
      reading: this.altered ? reading : "as learned",
    };
  }

  tickedClips(): ClipEntry[] {
    return this.clips.filter(({ ticked }) => ticked);
  }

  /** The run that the charts tell of. */
  get told(): Run | null {
    return this.chosen ?? this.runs.at(-1) ?? null;
  }

  /** Whether the model on the stage is still learning. */
  get learning(): boolean {
    return this.busy && this.chosen !== null && !isOver(this.chosen);
  }

  get busy(): boolean {
    return this.training.status !== "idle";
  }
}
