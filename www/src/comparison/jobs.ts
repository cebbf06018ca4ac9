// The progress of the trainings of a comparison. No rendering, no worker.
import type { Job, PlannedComparison, PlannedJob } from "../engine/whole-protocol";
import { type CostWords, waitWords } from "../training/cost";
import { compareWords } from "./view-words";

/** A job of the last press of Compare. */
export interface JobProgress {
  readonly id: string;
  readonly job: Job;
  state: "waiting" | "running" | "done" | "failed" | "cancelled";
  /** Share of its training that is done. */
  fraction: number;
  /** Seconds of its training so far. */
  elapsed: number;
  /** Why it failed. */
  why: string;
}

export function waiting({ id, job }: PlannedJob): JobProgress {
  return { id, job, state: "waiting", fraction: 0, elapsed: 0, why: "" };
}

/**
 * The open jobs: those without an outcome, and those of the first held-out trial without a motion to show,
 * because the results are from a file.
 */
export function openJobs(
  planned: readonly PlannedJob[],
  predictions: ReadonlyMap<string, unknown>,
): PlannedJob[] {
  const first = planned[0]?.job.heldOut;
  const most = Math.max(...planned.map(({ job }) => job.trainingTrials));
  return planned.filter(({ id, job, done }) => {
    const isShown = job.heldOut === first && job.trainingTrials === most;
    return !done || (isShown && !predictions.has(id));
  });
}

/** The cost of the open ones of planned jobs on `workers` workers. */
export function costOf(
  open: readonly PlannedJob[],
  { jobs, costs }: Pick<PlannedComparison, "jobs" | "costs">,
  width: number,
): CostWords {
  const all = costs.filter((_, place) => open.includes(jobs[place]!));
  const seconds = all.reduce((sum, cost) => sum + cost.seconds, 0) / width;
  const bytes = Math.max(0, ...all.map((cost) => cost.bytes)) * Math.min(width, open.length);
  const cost = waitWords({ seconds, bytes }, compareWords().shorter);
  return cost.words === "" && open.length > 0 ? { ...cost, words: compareWords().shortWait } : cost;
}

/** The rough work of a job relative to others. It predicts the time before a job of the same kind has run. */
const WEIGHTS: Record<Job["candidate"]["model"], (trials: number) => number> = {
  vcgpdm: (trials) => 2 * trials,
  vgpdm: (trials) => trials,
  "map-gpdm": (trials) => 15 * trials ** 2,
  "map-cgpdm": (trials) => 30 * trials ** 2,
  tmp: (trials) => 5 * trials,
  "dmp-discrete": (trials) => 0.05 * trials,
  "dmp-rhythmic": (trials) => 0.05 * trials,
};

const weight = ({ job }: JobProgress): number => WEIGHTS[job.candidate.model](job.trainingTrials);

const isOver = ({ state }: JobProgress): boolean => state === "done" || state === "failed";

/** The share of a job's work that is done. */
const shareOf = (progress: JobProgress): number => (isOver(progress) ? 1 : progress.fraction);

const sum = (jobs: readonly JobProgress[], value: (progress: JobProgress) => number): number =>
  jobs.reduce((total, progress) => total + value(progress), 0);

/** The share of all work of these jobs that is done, 0 to 1. */
export function share(jobs: readonly JobProgress[]): number {
  const whole = sum(jobs, weight);
  return whole > 0 ? sum(jobs, (progress) => weight(progress) * shareOf(progress)) / whole : 0;
}

/** The remaining seconds of these jobs on `workers` workers; null: too early to know. */
export function secondsLeft(jobs: readonly JobProgress[], workers: number): number | null {
  const begun = jobs.filter((progress) => progress.elapsed > 0 && shareOf(progress) > 0.02);
  if (sum(begun, ({ elapsed }) => elapsed) < 1) return null;
  /** Seconds for a unit of work, from jobs of the same model or else from all. */
  const rate = ({ job }: JobProgress) => {
    const same = begun.filter((other) => other.job.candidate.model === job.candidate.model);
    const examples = same.length > 0 ? same : begun;
    return sum(examples, (progress) => progress.elapsed / shareOf(progress)) / sum(examples, weight);
  };
  const rests = jobs
    .filter((progress) => !isOver(progress) && progress.state !== "cancelled")
    .map((progress) => rate(progress) * weight(progress) * (1 - progress.fraction));
  return Math.max(rests.reduce((a, b) => a + b, 0) / Math.max(1, workers), ...rests, 0);
}

/** How a comparison ended. */
export function summary(jobs: readonly JobProgress[]): string {
  if (jobs.length === 0) return compareWords().finishedBefore;
  const count = (state: JobProgress["state"]) => jobs.filter((progress) => progress.state === state).length;
  return compareWords().summary(count("done"), jobs.length, count("failed"), count("cancelled") > 0);
}
