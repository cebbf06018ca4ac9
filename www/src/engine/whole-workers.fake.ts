// For tests: a whole program without wasm. The test controls its workers.
export { settled } from "./engine.fake";
import { FakeLibraries } from "./library.fake";
import { type Hired, Pool } from "./pool";
import type { RolloutRequest, TrainingClip, TrainingOutcome, TrainingReport } from "./protocol";
import { FakeSeries } from "./series.fake";
import type { WholeCalls, WholeWorkers } from "./whole-workers";
import type {
  AnswersFile,
  ByHand,
  ComparisonSettings,
  Evaluated,
  EvaluationJob,
  Experiment,
  FinishedJob,
  Job,
  CompletionRequest,
  MadeMotion,
  ModelKind,
  Outcome,
  PartMoments,
  PerceptionResults,
  Plan,
  ResultsView,
  Setting,
  StudyInfo,
  StudyTrial,
  StudyView,
  SyntheticTruth,
  TrainedExperiment,
} from "./whole-protocol";

/** A call that the test ends. */
export interface Pending<Request, Report, Result> {
  request: Request;
  report(report: Report): void;
  end(result: Result): void;
  fail(problem: Error): void;
  /** Lets the worker of the call die. */
  die(problem: Error): void;
}

const outcome: Outcome = {
  score: { dtwMse: 0.01, mse: 0.02, variance: 0.03 },
  bound: null,
  objective: 0,
  iterations: 1,
  seconds: 1,
  frames: 10,
  storedNumbers: 5,
  reason: null,
};

export const evaluated: Evaluated = {
  outcome,
  predicted: new Float32Array(6),
  actual: new Float32Array(6),
  frameTime: 0.1,
  model: '{"kind":"tmp"}',
};

export const clip = (id: number): TrainingClip => ({
  id,
  source: { sample: `clip ${id}` },
  first: 0,
  end: 100,
});

/** The motion of a model of another kind, whose document has only its kind. */
function made(text: string, frames: number, handles: ByHand = {}): MadeMotion {
  const { kind } = JSON.parse(text) as { kind: ModelKind };
  const figure = { nodes: [{ joint: 0, parent: null, endSite: false }] };
  const joints = [{ name: "hips", parent: null, channels: [] }];
  const motion = { positions: new Float32Array(3 * frames), frames, nodes: 1, frameTime: 0.1 };
  const parts = [{ name: "whole", joints: [0] }];
  const alpha = kind === "map-cgpdm" ? [[2]] : [];
  return { kind, figure, joints, parts, motion, bvh: "HIERARCHY", handles, alpha };
}

const idOf = ({ candidate, heldOut, trainingTrials, seed }: Job) =>
  `${candidate.model} ${heldOut + 1} of ${trainingTrials} seed ${seed}`;

function settingOf(clips: readonly TrainingClip[], { parts, framesPerSecond }: ComparisonSettings): Setting {
  const trials = clips.map(({ id }) => ({ name: `clip ${id}`, sha256: String(id), piece: null }));
  return { trials, parts, framesPerSecond, startFrames: 5 };
}

const candidateOf = (model: ModelKind): Job["candidate"] =>
  model === "dmp-discrete" || model === "dmp-rhythmic"
    ? { model, bases: 20 }
    : { model: "tmp", primitives: null };

function jobsOf(plan: Plan, trials: number): Job[] {
  const folds = plan.heldOut.length > 0 ? plan.heldOut : Array.from({ length: trials }, (_, trial) => trial);
  return folds.flatMap((heldOut) =>
    plan.models.map((model) => ({
      candidate: candidateOf(model),
      heldOut,
      trainingTrials: trials - 1,
      seed: 0,
    })),
  );
}

/** Results with these finished jobs. */
export function resultsOf(setting: Setting, jobs: readonly Job[]): ResultsView {
  const finished: FinishedJob[] = jobs.map((job) => ({
    id: idOf(job),
    job,
    engine: "fake",
    outcome,
    failure: null,
  }));
  const comparison = { parts: [], models: [], correlations: [], growth: [], evidence: [], claims: [] };
  return { text: JSON.stringify({ setting, jobs }), setting, finished, comparison };
}

/** Results from a file: the first jobs of a plan on these clips. */
export function savedResults(
  clips: readonly TrainingClip[],
  settings: ComparisonSettings,
  models: ModelKind[],
): string {
  const jobs = models.map((model) => ({
    candidate: candidateOf(model),
    heldOut: 0,
    trainingTrials: clips.length - 1,
    seed: 0,
  }));
  return resultsOf(settingOf(clips, settings), jobs).text;
}

const read = (text: string) => JSON.parse(text) as { setting: Setting; jobs: Job[] };

/** The error of a program that refuses an input. */
export function refusal(message: string): Error {
  const error = new Error(message);
  error.name = "VcgpdmError";
  return error;
}

/**
 * The study that the fake program reads from every text. The title of the study is the text, and all trials
 * are in one block.
 */
export interface FakeStudies {
  study: StudyInfo;
  trials: StudyTrial[];
}

export class FakeProgram implements WholeWorkers {
  /** Null: the program refuses every text as a study. */
  studies: FakeStudies | null = null;
  readonly evaluations: Pending<EvaluationJob, number, Evaluated>[] = [];
  readonly draws: Pending<Experiment, never, SyntheticTruth>[] = [];
  readonly trainings: Pending<Experiment, TrainingReport<TrainedExperiment>, TrainingOutcome>[] = [];
  readonly analyses: Pending<AnswersFile[], never, PerceptionResults>[] = [];
  readonly moments: Pending<RolloutRequest, never, PartMoments[]>[] = [];
  /** The documents of the models opened for moments and images. */
  readonly outlooks: string[] = [];
  readonly completions: CompletionRequest[] = [];
  readonly starts: Pending<{ text: string; clip: TrainingClip; frames: number }, never, number[][][]>[] = [];
  readonly libraries = new FakeLibraries();
  readonly series = new FakeSeries();
  /** The states and files to which outcomes were to be added. */
  readonly sent: (number | string)[] = [];
  /** The errors of the next calls for results and completions, in order. */
  readonly failures: Error[] = [];
  /** The reason why plans are refused; empty if they are accepted. */
  refused = "";
  /** The reason why the program cannot be loaded; empty if it can. */
  unreachable = "";
  plans = 0;
  readonly pool = new Pool(2, () => this.#hire());
  readonly desk = new Pool(1, () => this.#hire());
  readonly library = new Pool(1, () => this.#hire());

  #hire(): Hired<WholeCalls> {
    let die: (problem: Error) => void = () => {};
    const broken = new Promise<never>((_, fail) => {
      die = fail;
    });
    const pending = <Request, Report, Result>(
      list: Pending<Request, Report, Result>[],
      request: Request,
      report: (report: Report) => void,
    ) => new Promise<Result>((end, fail) => list.push({ request, report, end, fail, die }));
    const ready = this.unreachable ? Promise.reject(new Error(this.unreachable)) : Promise.resolve();
    return { worker: this.#worker(pending) as WholeCalls, ready, broken, dismiss: () => {} };
  }

  #study(text: string): StudyView {
    if (!this.studies) throw refusal("this is no study");
    return {
      text,
      info: { ...this.studies.study, title: text },
      trials: this.studies.trials.length,
      plans: [],
    };
  }

  #worker(
    pending: <Request, Report, Result>(
      list: Pending<Request, Report, Result>[],
      request: Request,
      report: (report: Report) => void,
    ) => Promise<Result>,
  ): Partial<WholeCalls> {
    const failing = () => {
      const problem = this.failures.shift();
      if (problem) throw problem;
    };
    /** The results that this worker holds. */
    let held: (ReturnType<typeof read> & { state: number }) | null = null;
    const cancelled = (signal: AbortSignal) =>
      new Promise<void>((stop) => signal.addEventListener("abort", () => stop(), { once: true }));
    return {
      ...this.libraries.worker(),
      ...this.series.worker(),
      planComparison: async (clips, settings, plan, known) => {
        this.plans += 1;
        if (this.refused) throw refusal(this.refused);
        const setting = settingOf(clips, settings);
        const other = known === null ? null : read(known);
        const goesOn = other !== null && JSON.stringify(other.setting) === JSON.stringify(setting);
        const done = goesOn ? other.jobs : [];
        const jobs = jobsOf(plan, clips.length).map((job) => {
          const id = idOf(job);
          return { id, job, done: done.some((known) => idOf(known) === id) };
        });
        const costs = jobs.map(() => ({ seconds: 60, bytes: 1e7 }));
        return { results: resultsOf(setting, done), jobs, costs, goesOn };
      },
      addOutcome: async (from, job) => {
        this.sent.push(from);
        failing();
        if (typeof from === "number" && from !== held?.state) return null;
        if (typeof from === "string") held = { state: 0, ...read(from) };
        const { setting, jobs } = held!;
        held = { state: Math.random(), setting, jobs: [...jobs, job] };
        const { finished, comparison } = resultsOf(setting, [job]);
        const text = JSON.stringify(job);
        return {
          state: held.state,
          text,
          isWhole: false,
          finished: finished[0]!,
          place: jobs.length,
          comparison,
        };
      },
      openResults: async (text) => {
        failing();
        const { setting, jobs } = read(text);
        return resultsOf(setting, jobs);
      },
      evaluate: (job, report, signal) =>
        Promise.race([pending(this.evaluations, job, report), cancelled(signal).then(() => null)]),
      drawExperiment: (experiment) => pending(this.draws, experiment, () => {}),
      openStudy: async (text) => this.#study(text),
      changeStudy: async (text, change) => this.#study(`${text} ${JSON.stringify(change)}`),
      drawTrials: async () => this.studies?.trials ?? [],
      movements: async () => (this.studies?.study.stimuli ?? []).map(() => new Float32Array(6)),
      analysePerception: (_, answers) => pending(this.analyses, answers, () => {}),
      perceptionJson: async (text, answers) => JSON.stringify({ text, answers }),
      makeStudy: async ({ generated }) => `a study of ${generated.length}`,
      openOutlook: async (text) => {
        this.outlooks.push(text);
      },
      rollOutAny: async (text, frames, handles) => made(text, frames, handles),
      complete: async (request) => {
        this.completions.push(request);
        failing();
        const motion = { positions: new Float32Array(12), frames: 2, nodes: 2, frameTime: 0.1 };
        const score = { mse: 1, mseMeanPose: 2, coverage95: 0.9, logDensity: 3 };
        return {
          motion,
          recorded: motion,
          latents: new Float64Array(4),
          scores: [{ part: "other", ...score }],
        };
      },
      columnsBvh: async (columns, frames) => {
        failing();
        return `HIERARCHY of ${columns.length} numbers in ${frames} frames`;
      },
      inferStart: (text, clip, frames) => pending(this.starts, { text, clip, frames }, () => {}),
      moments: (request) => pending(this.moments, request, () => {}),
      trainExperiment: (experiment, report, signal) =>
        Promise.race([
          pending(this.trainings, experiment, report),
          cancelled(signal).then((): TrainingOutcome => ({ cancelled: true, reason: null })),
        ]),
    };
  }
}
