// A comparison of models: which trainings it asks for, how far they are, and what came of them. No rendering, no worker.
import type { Candidate, Figure, Job, ModelId, PartSpec, Results, Setting, TrainingClip } from "../engine/protocol";
import { seedsFrom } from "../training/runs";
import { MODELS, type Settings } from "../settings/settings";

/** One model in one fold with one seed. */
export interface StudyJob {
  job: Job;
  state: "waiting" | "running" | "done" | "failed" | "cancelled";
  /** Share of its training that is done. */
  fraction: number;
  /** Seconds of its training so far. */
  elapsed: number;
  /** Why it failed, in words. */
  why: string;
}

/** World positions of a motion [frames x nodes x 3]. */
export interface Positions {
  positions: Float32Array;
  /** Seconds between frames. */
  frameTime: number;
}

/** What was compared on what, and what came of it. */
export interface Study {
  /** Tells studies of other trials, parts or frame rates apart. */
  key: string;
  /** None: the results are from a file. */
  clips: TrainingClip[];
  titles: string[];
  body: { figure: Figure; joints: string[]; parts: PartSpec[] } | null;
  framesPerSecond: number;
  results: Results;
  /** What the last press of Compare asked for. */
  jobs: StudyJob[];
  /** What models trained on all other trials predict, by the job's key. */
  predictions: Map<string, Positions>;
  /** The trials held out, by their number. */
  actual: Map<number, Positions>;
}

/** Tells one model with its settings from another, in whatever order its entries stand. */
export function candidateKey(candidate: Candidate): string {
  const entries = Object.entries(candidate).filter(([, value]) => value !== null && value !== undefined);
  return JSON.stringify(entries.sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** Tells one job from another. */
export function jobKey({ candidate, held_out, training_trials, seed }: Job): string {
  return JSON.stringify([candidateKey(candidate), held_out, training_trials, seed]);
}

/** The order of tables: by model, then by the size of the settings, then by seed; whatever was finished first. */
export function inOrder(a: Job, b: Job): number {
  const size = ({ candidate }: Job) =>
    "bases" in candidate ? candidate.bases : "dynamics_ips" in candidate ? candidate.dynamics_ips : 0;
  const model = ({ candidate }: Job) => MODELS.indexOf(candidate.model);
  return model(a) - model(b) || size(a) - size(b) || a.seed - b.seed;
}

/** The same for these clips, parts and rate, whenever they are asked for. */
export function studyKey(clips: readonly TrainingClip[], parts: readonly PartSpec[], framesPerSecond: number): string {
  return JSON.stringify([clips.map(({ id, first, end }) => [id, first, end]), parts, framesPerSecond]);
}

/** Whether results of two places go together. */
export function sameSetting(a: Setting, b: Setting): boolean {
  const of = ({ trials, parts, frames_per_second, start_frames }: Setting) =>
    JSON.stringify([
      trials.map(({ sha256, piece }) => [sha256, piece ?? null]),
      parts.map(({ joints }) => joints),
      frames_per_second,
      start_frames,
    ]);
  return of(a) === of(b);
}

/** The jobs that still have to be done: those without an outcome, and of the first fold those of which there is no motion to show. */
export function openJobs(asked: readonly Job[], study: Pick<Study, "results" | "predictions"> | null): Job[] {
  if (!study) return [...asked];
  const known = new Set(study.results.finished.filter(({ outcome }) => outcome).map(({ job }) => jobKey(job)));
  const all = study.results.setting.trials.length - 1;
  return asked.filter((job) => {
    const key = jobKey(job);
    if (!known.has(key)) return true;
    return job.held_out === asked[0]!.held_out && job.training_trials === all && !study.predictions.has(key);
  });
}

/** Coupled models need parts to couple. */
export const isCoupled = (model: ModelId): boolean => model === "vcgpdm" || model === "map-cgpdm";

/** The models with all settings that are asked for, of a body in so many parts. */
export function candidates(settings: Settings, parts: number): Candidate[] {
  const { latent, order, comparedIterations: max_iterations, ips, bases, balanced } = settings;
  return settings.models
    .filter((model) => parts > 1 || !isCoupled(model))
    .flatMap((model): Candidate[] => {
      switch (model) {
        case "vcgpdm":
        case "vgpdm":
          return ips.map((ips) => ({ model, latent, order, dynamics_ips: ips, pose_ips: ips, max_iterations }));
        case "map-gpdm":
        case "map-cgpdm":
          return [{ model, latent, order, max_iterations, balanced }];
        case "tmp":
          return [{ model, primitives: null }];
        default:
          return bases.map((bases) => ({ model, bases }));
      }
    });
}

/** Whether another seed gives another model. */
const isRandom = ({ model }: Candidate) => model.endsWith("gpdm");

/** The jobs that the settings ask for on so many trials, of a body in so many parts: fold after fold, so that the first tables come early. */
export function jobs(settings: Settings, trials: number, parts: number): Job[] {
  const all = candidates(settings, parts);
  const held =
    settings.heldOut >= 1 && settings.heldOut <= trials
      ? [settings.heldOut]
      : Array.from({ length: trials }, (_, k) => k + 1);
  const seeds = (candidate: Candidate) => (isRandom(candidate) ? seedsFrom(settings.seed, settings.seeds) : [0]);
  const asked = held.flatMap((held_out) =>
    all.flatMap((candidate) =>
      seeds(candidate).map((seed) => ({ candidate, held_out, training_trials: trials - 1, seed })),
    ),
  );
  if (!settings.growth) return asked;
  // The middle one of the numbers of inducing points stands for all.
  const one = (model: ModelId) => {
    const of = all.filter((candidate) => candidate.model === model);
    return of.slice(of.length >> 1, (of.length >> 1) + 1);
  };
  const fewer = MODELS.filter(isCoupled)
    .flatMap(one)
    .flatMap((candidate) =>
      Array.from({ length: Math.max(0, trials - 2) }, (_, k) => ({
        candidate,
        held_out: held[0] ?? 1,
        training_trials: k + 1,
        seed: settings.seed,
      })),
    );
  return [...asked, ...fewer];
}

/** How much work a job is beside others, roughly: only used to say how long the rest takes before any of its kind has run. */
function weight({ candidate, training_trials }: Job): number {
  const kind = {
    vcgpdm: 2,
    vgpdm: 1,
    "map-gpdm": 15,
    "map-cgpdm": 30,
    tmp: 5,
    "dmp-discrete": 0.05,
    "dmp-rhythmic": 0.05,
  }[candidate.model];
  return candidate.model.startsWith("map") ? kind * training_trials ** 2 : kind * training_trials;
}

const isOver = ({ state }: StudyJob): boolean => state === "done" || state === "failed";

/** The share of a job's work that is done. */
const behind = (one: StudyJob): number => (isOver(one) ? 1 : one.fraction);

/** The share of all work that is behind these jobs, 0 to 1. */
export function share(of: readonly StudyJob[]): number {
  let [done, all] = [0, 0];
  for (const one of of) {
    const size = weight(one.job);
    all += size;
    done += size * behind(one);
  }
  return all > 0 ? done / all : 0;
}

/** Seconds that these jobs still take, so many at once; null while it is too early to say. */
export function secondsLeft(of: readonly StudyJob[], workers: number): number | null {
  const begun = of.filter((one) => one.elapsed > 0 && behind(one) > 0.02);
  const sum = (some: readonly StudyJob[], value: (one: StudyJob) => number) =>
    some.reduce((total, one) => total + value(one), 0);
  if (sum(begun, ({ elapsed }) => elapsed) < 1) return null;
  /** Seconds that a unit of work takes: by what jobs of the same model took, else by all. */
  const rate = ({ job }: StudyJob) => {
    const same = begun.filter((other) => other.job.candidate.model === job.candidate.model);
    const from = same.length > 0 ? same : begun;
    return sum(from, (one) => one.elapsed / behind(one)) / sum(from, (one) => weight(one.job));
  };
  const rests = of
    .filter((one) => !isOver(one) && one.state !== "cancelled")
    .map((one) => rate(one) * weight(one.job) * (1 - one.fraction));
  return Math.max(rests.reduce((a, b) => a + b, 0) / Math.max(1, workers), ...rests, 0);
}
