// For tests: an engine and a pool that compute nothing. The test decides when they answer.
import type { StartedEngine } from "./engine";
import { Pool } from "./pool";
import type { TrainingWorker } from "./whole-workers";
import type {
  Clash,
  ClipCalls,
  ClipInfo,
  ClipSource,
  CostQuestion,
  DocumentKind,
  Engine,
  Health,
  LiveChange,
  LiveStep,
  LiveFrames,
  ModelInfo,
  ModelView,
  Motion,
  OpenedModel,
  PartSpec,
  Report,
  RolloutRequest,
  RolloutResult,
  SampleInfo,
  ShownClip,
  TrainedModel,
  TrainingClip,
  PlannedTraining,
  TrainingJob,
  TrainingOutcome,
  TrainingProgress,
} from "./protocol";

/** Two joints and two nodes that do not move. */
export const figure = {
  nodes: [
    { joint: 0, parent: null, endSite: false },
    { joint: 1, parent: 0, endSite: false },
  ],
};
export const joints = ["hips", "chest"].map((name, joint) => ({
  name,
  parent: joint === 0 ? null : 0,
  channels: [],
}));
const parts: PartSpec[] = [
  { name: "lower", joints: [0] },
  { name: "upper", joints: [1] },
];

export const MOVES_ON: Health = { state: "moves-on", from: null, part: null, rank: 3, pace: null, parts: [] };
export const STANDS_STILL: Health = {
  state: "stands-still",
  from: 2.4,
  part: null,
  rank: 1,
  pace: null,
  parts: [],
};

function still(frames: number): Motion {
  return { positions: new Float32Array(frames * 6), frames, nodes: 2, frameTime: 1 / 30 };
}

/** The document of a model: a seed that identifies it, and the number of its sequences. */
export function modelText(seed: number, sequences = 1): string {
  return JSON.stringify({ seed, sequences });
}

function infoOf(text: string): ModelInfo {
  const { seed, sequences } = JSON.parse(text) as { seed: number; sequences: number };
  const terms = { kinematics: [], dynamics: [], initial: 0, entropy: 0 };
  const settings = { parts, latent: 2, dynamicsIps: 4, poseIps: 4, order: 2, framesPerSecond: 30, seed };
  return {
    kind: "vcgpdm",
    parts: parts.map((part) => ({ ...part, latent: 2, poseIps: 4 })),
    columns: [],
    order: 2,
    frameTime: 1 / 30,
    alpha: [
      [1, 4],
      [4, 1],
    ],
    dynamicsIps: [
      [4, 4],
      [4, 4],
    ],
    startFrames: Array.from({ length: sequences }, () => 89),
    sequences: Array.from({ length: sequences }, (_, i) => ({
      name: `walk ${i}`,
      sha256: `${i}`,
      frames: 90,
      restsFrom: null,
      piece: null,
      bonesOf: null,
      whole: true,
    })),
    joints,
    figure,
    dynamicsElbo: 0,
    provenance: {
      engine: "fake",
      settings: { ...settings, maxIterations: 100 },
      bound: 0,
      objective: 0,
      terms,
      iterations: 1,
      evaluations: 1,
      note: null,
    },
  };
}

/** A fake hash of a model's document, different for each seed. */
export function modelHash(seed: number): string {
  return seed.toString(16).padStart(8, "0").padEnd(64, "f");
}

function viewOf(text: string, revision: number): ModelView {
  const info = infoOf(text);
  const sha256 = modelHash(info.provenance.settings.seed);
  return { revision, sha256, info, poseInducing: [], dynamicsInducing: [], trainingLatents: null };
}

function shownClip(frames = 60): ShownClip {
  const info = {
    joints,
    figure,
    frames,
    frameTime: 1 / 30,
    upAxis: "y",
    warnings: [],
    bodies: [],
    presets: [{ id: "lower-upper", title: "", parts }],
  };
  return { info: info as unknown as ClipInfo, motion: still(frames) };
}

type Call = keyof Engine | keyof ClipCalls;

/** A call whose answer waits for the test. */
interface HeldCall {
  name: Call;
  args: unknown[];
  end(): void;
  fail(problem: Error): void;
}

export class FakeEngine implements Partial<Engine>, ClipCalls {
  /** The names of the calls whose answers wait for the test. */
  readonly holding = new Set<Call>();
  readonly held: HeldCall[] = [];
  /** All requested rollouts. */
  readonly rollouts: RolloutRequest[] = [];
  /** The clips that cannot be trained on with others. */
  readonly odd = new Set<number>();
  /** The clips of a body with longer bones. */
  readonly longer = new Set<number>();
  /** The names of the joints of the next clips that are read; else those of the sample clips. */
  readonly bodies: string[][] = [];
  /** The health of all rollouts. */
  health: Health = MOVES_ON;
  /** The live rollout, if there is one: its changes and the number of its frames. */
  live: FakeLive | null = null;
  /** The document of the open model. */
  text = "";
  #revision = 0;

  #answer<Answer>(name: Call, args: unknown[], answer: Answer): Promise<Answer> {
    if (!this.holding.has(name)) return Promise.resolve(answer);
    return new Promise((end, fail) => this.held.push({ name, args, end: () => end(answer), fail }));
  }

  #roll(request: RolloutRequest): RolloutResult {
    const { alpha } = infoOf(this.text);
    return {
      revision: this.#revision,
      request,
      motion: still(request.frames),
      latents: [],
      weights: request.alpha ?? alpha,
    };
  }

  freshSeed(): Promise<number> {
    return this.#answer("freshSeed", [], 77);
  }

  readClip(source: ClipSource): Promise<ShownClip> {
    if ("file" in source && source.file.size === 0) return Promise.reject(new Error("the file is empty"));
    const clip = shownClip();
    if ("file" in source && source.up) clip.info.upAxis = source.up;
    if ("file" in source && source.fps) clip.info.frameTime = 1 / source.fps;
    const names = this.bodies.shift();
    if (names) clip.info.joints = names.map((name, joint) => ({ ...clip.info.joints[joint]!, name }));
    return this.#answer("readClip", [source], clip);
  }

  sampleClip(id: string): Promise<ShownClip> {
    return this.#answer("sampleClip", [id], shownClip());
  }

  madeClips(): Promise<SampleInfo[]> {
    const ids = ["walk-1", "bottle-1", "bottle-2"];
    const movement = (id: string) => (id === "walk-1" ? "walk" : "pass a bottle");
    return this.#answer(
      "madeClips",
      [],
      ids.map((id) => ({ id, title: id, movement: movement(id) })),
    );
  }

  checkTogether(clips: TrainingClip[]): Promise<Clash | null> {
    const odd = clips.some(({ id }) => this.odd.has(id)) && { words: "their bodies differ", bones: false };
    const isLonger = ({ id, firstBones }: TrainingClip) => this.longer.has(id) && !firstBones;
    const longer = clips.some(isLonger) && { words: "their bones differ", bones: true };
    return this.#answer("checkTogether", [clips], odd || longer || null);
  }

  documentKind(text: string): Promise<DocumentKind> {
    const { kind = "model" } = text.startsWith("{") ? (JSON.parse(text) as { kind?: DocumentKind }) : {};
    return this.#answer("documentKind", [], text.startsWith("[") ? "list" : kind);
  }

  bestToShow(ranks: number[], errors: number[]): Promise<number> {
    const places = ranks.map((_, place) => place);
    const value = (place: number) => (ranks[place] ?? 0) * 1e9 - (errors[place] ?? 0);
    places.sort((a, b) => value(b) - value(a));
    return this.#answer("bestToShow", [ranks, errors], places[0] ?? -1);
  }

  trainingCost({ settings, frames, longest }: CostQuestion): Promise<PlannedTraining> {
    const seconds = (frames * settings.maxIterations) / 1000;
    const points = longest >= 8 ? 30 : 12;
    const usual = { latent: 3, dynamicsIps: points, poseIps: points, order: 2, maxIterations: 250 };
    return this.#answer("trainingCost", [frames], { seconds, bytes: 1e6, usual, longest });
  }

  openModel(text: string, frames: number): Promise<OpenedModel> {
    if (!text.startsWith("{")) return Promise.reject(new Error("expected a model"));
    this.text = text;
    this.#revision += 1;
    const rollout = this.#roll({ frames, sequence: 0, alpha: null, reading: "as-learned" });
    return this.#answer("openModel", [text], { model: viewOf(text, this.#revision), rollout });
  }

  rollout(request: RolloutRequest): Promise<RolloutResult> {
    this.rollouts.push(request);
    return this.#answer("rollout", [request], this.#roll(request));
  }

  inducing(point: Parameters<Engine["inducing"]>[0]): ReturnType<Engine["inducing"]> {
    const poses = point.kind === "pose" ? 1 : 2;
    const report = {
      point,
      poses: Array.from({ length: poses }, () => new Float32Array(6)),
      frames: new Float64Array(3),
    };
    return this.#answer("inducing", [point], report);
  }

  modelJson(): Promise<string> {
    return this.#answer("modelJson", [], this.text);
  }

  rolloutBvh(request: RolloutRequest): Promise<string> {
    return this.#answer("rolloutBvh", [request], "HIERARCHY");
  }

  bodyReport(request: RolloutRequest): ReturnType<Engine["bodyReport"]> {
    const limb = { swing: 0.2, period: 1, locking: 1 };
    const measures = { limbs: [], parts: [limb, limb], jointSpeed: 1, walkingSpeed: 1, footSlide: 0.1 };
    const { health } = this;
    return this.#answer("bodyReport", [request], { revision: this.#revision, request, measures, health });
  }

  predictions(request: RolloutRequest): ReturnType<Engine["predictions"]> {
    const rows = request.frames - 2;
    const constant = () => ({
      means: new Float64Array(2 * rows),
      variances: new Float64Array(rows).fill(0.04),
    });
    const parts = [0, 1].map(() => ({ experts: [constant(), constant()], product: constant() }));
    return this.#answer("predictions", [request], {
      revision: this.#revision,
      request,
      firstFrame: 2,
      parts,
    });
  }

  futures(request: RolloutRequest, count: number, seed: number): Promise<RolloutResult[]> {
    const results = Array.from({ length: count }, () => this.#roll(request));
    return this.#answer("futures", [request, count, seed], results);
  }

  bodyPose(latents: Float64Array): Promise<Float32Array> {
    return this.#answer("bodyPose", [latents], new Float32Array(3));
  }

  poseVariance(part: number, latents: Float64Array): Promise<Float64Array> {
    return this.#answer("poseVariance", [part, latents], new Float64Array(latents.length / 2));
  }

  startLive(request: RolloutRequest, frame: number): Promise<void> {
    this.live = new FakeLive();
    return this.#answer("startLive", [request, frame], undefined);
  }

  advanceLive(step: LiveStep): Promise<LiveFrames> {
    if (!this.live) return Promise.reject(new Error("The live motion ended: start it again."));
    this.live.take(step);
    return this.#answer("advanceLive", [step], liveFrames(still(step.frames), this.live.changes));
  }

  endLive(): Promise<void> {
    this.live = null;
    return this.#answer("endLive", [], undefined);
  }

  clipBvh({ id, first, end }: TrainingClip): Promise<string> {
    return this.#answer("clipBvh", [id, first, end], `HIERARCHY of clip ${id}, ${first} to ${end}`);
  }
}

/** A live motion that computes nothing. */
export class FakeLive {
  #made: { after: number; change: LiveChange }[] = [];
  #frames = 0;
  readonly steps: LiveStep[] = [];

  /** The changes in the frames that were not taken back. */
  get changes(): LiveChange[] {
    return this.#made.map(({ change }) => change);
  }

  take(step: LiveStep): void {
    const { back, changes, frames } = step;
    if (back > this.#frames) throw new Error(`expected frames to take back from 0 to ${this.#frames}`);
    this.steps.push(step);
    this.#frames -= back;
    if (back > 0) this.#made = this.#made.filter(({ after }) => after < this.#frames);
    this.#made.push(...changes.map((change) => ({ after: this.#frames, change })));
    this.#frames += frames;
  }
}

/** Frames of two parts; recordings begin at their frame 5 at once. */
export function liveFrames(motion: Motion, changes: readonly LiveChange[]): LiveFrames {
  const count = 2 * motion.frames;
  const recorded = new Int32Array(count).fill(-1);
  for (const part of [0, 1]) {
    const last = changes.findLast((change) => "part" in change && change.part === part);
    if (last?.kind === "record") for (let k = 0; k < motion.frames; k++) recorded[2 * k + part] = 5 + k;
  }
  const [latents, phases, distances] = [
    [0, 1].map(() => new Float64Array(count)),
    new Float64Array(count),
    new Float64Array(count),
  ];
  const columns = new Float64Array(motion.frames).fill(motion.frames);
  return { motion, latents, columns, phases, distances, recorded };
}

/** A training that a worker was asked to start or to continue. */
interface HeldTraining {
  job: TrainingJob;
  /** The number of the worker, counted from 0. */
  worker: number;
  /** The number of further iterations; null for a new training. */
  more: number | null;
  signal: AbortSignal;
  /**
   * Sends a report with this iteration, its bound and, if given, the best model so far. Returns whether the
   * page asks for the best model.
   */
  report(iteration: number, bound: number, model?: string, health?: Health, error?: number): boolean;
  /** Sends the first report with these notices. */
  begin(notices: string[]): void;
  end(outcome: TrainingOutcome): void;
  fail(problem: Error): void;
  /** Lets the worker die. */
  die(problem: Error): void;
}

export class FakeTrainers {
  readonly trainings: HeldTraining[] = [];
  /** The number of dismissed workers. */
  dismissed = 0;
  /** The number of started workers. */
  hired = 0;
  readonly pool: Pool<TrainingWorker>;

  constructor(width: number) {
    this.pool = new Pool(width, () => this.#hire());
  }

  #hire() {
    let die = (_: Error) => {};
    const broken = new Promise<never>((_, fail) => {
      die = fail;
    });
    const number = this.hired;
    this.hired += 1;
    let last: TrainingJob | null = null;
    const hold = (job: TrainingJob, more: number | null, send: Report<TrainedModel>, signal: AbortSignal) =>
      new Promise<TrainingOutcome>((end, fail) => {
        last = job;
        const report = (
          iteration: number,
          bound: number,
          text?: string,
          health: Health = MOVES_ON,
          error = -bound,
        ) => {
          const found = text === undefined ? null : { text, latents: [], health, error };
          const step = progress(iteration, bound);
          return send({ steps: [step], progress: step, elapsed: iteration, found }) === true;
        };
        const begin = (notices: string[]) =>
          void send({ steps: [], progress: progress(0, 0), elapsed: 0, found: null, notices });
        this.trainings.push({ job, worker: number, more, signal, report, begin, end, fail, die });
      });
    const worker: TrainingWorker = {
      train: (job, send, signal) => hold(job, null, send, signal),
      goOn: (more, send, signal) =>
        last ? hold(last, more, send, signal) : Promise.reject(new Error("nothing to go on with")),
    };
    const dismiss = () => {
      this.dismissed += 1;
    };
    return { worker, ready: Promise.resolve(), broken, dismiss };
  }
}

/** The progress of a training after an iteration. */
export function progress(iteration: number, bound = 0): TrainingProgress {
  const terms = { kinematics: [], dynamics: [], initial: 0, entropy: 0 };
  const setbacks = { jittered: 0, turnedBack: 0 };
  const rest = {
    terms,
    evaluations: iteration,
    phase: "everything" as const,
    setbacks,
    done: false,
    reason: null,
  };
  return {
    ...rest,
    iteration,
    maxIterations: 100,
    bound,
    best: bound,
    fraction: iteration / 100,
  } as TrainingProgress;
}

/** The answer of a start of the engine. */
export function started(engine: FakeEngine, trainers = new FakeTrainers(2)): StartedEngine {
  const samples = ["walk-1", "walk-2", "wave-1"].map((id) => ({
    id,
    title: id,
    movement: id.split("-")[0] ?? "",
  }));
  return {
    engine: engine as unknown as Engine,
    clips: engine,
    pool: trainers.pool,
    version: "1.2.3",
    samples,
  };
}

/** Waits until all promises that are ready have been handled. */
export function settled(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
}
