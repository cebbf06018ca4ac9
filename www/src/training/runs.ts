// Trainings as data: their comparison, and the time that remains. No rendering, no worker.
import { troubleText } from "../couplings/measures-text";
import type { TermName } from "../terms/terms";
import type { ClipSource, TrainedModel, TrainingProgress, TrainingSettings } from "../engine/protocol";
import { lab, shownPart } from "../words/lab";

export interface RunClip {
  id: number;
  title: string;
  source: ClipSource;
  first: number;
  end: number;
  firstBones?: boolean;
}

/** A training that waits, runs or is over. */
export interface Run {
  id: number;
  settings: TrainingSettings;
  clips: RunClip[];
  state: "waiting" | "running" | "done" | "cancelled" | "failed";
  /** The course of the bound [iterations]. */
  steps: TrainingProgress[];
  /** Seconds of training. */
  elapsed: number;
  /** How it ended, in plain words. */
  ending: string;
  /** The newest model that the page has received. */
  model: TrainedModel | null;
  /** The iterations of the first request; each continuation gets as many again. */
  portion: number;
  /** Whether it stopped before its bound had settled. */
  open: boolean;
  /** Whether it is being trained again up to where it stopped. */
  catchingUp: boolean;
}

export const isOver = ({ state }: Pick<Run, "state">): boolean => state !== "waiting" && state !== "running";

/** The best bound so far; minus infinity before the first iteration. */
export function bestBound(run: Run): number {
  return run.steps.at(-1)?.best ?? -Infinity;
}

/** The run with the highest bound. */
export function bestRun(runs: readonly Run[]): Run | null {
  return runs.reduce<Run | null>(
    (best, run) => (best && bestBound(best) >= bestBound(run) ? best : run),
    null,
  );
}

/** How the rollout of a run's model ends; empty when it moves on. */
export function endOfMotion({ model, settings }: Pick<Run, "model" | "settings">): string {
  const health = model?.health;
  if (!model || health?.state === "moves-on") return "";
  const { motion } = lab().learn.ending;
  if (!health || health.state === "not-finite") return motion.breaksDown;
  if (health.state === "rests-as-recorded") return motion.rests;
  const names = settings.parts.map(({ name }) => shownPart(name));
  const since = health.from === null ? "" : lab().measured.since(health.from);
  return health.state === "leaves-training-range" ? motion.farFromClips(since) : troubleText(health, names);
}

/** The seeds of several trainings: first, first + 1, ...; after the largest seed comes 0. */
export function seedsFrom(first: number, count: number): number[] {
  return Array.from({ length: count }, (_, i) => (first + i) % 2 ** 32);
}

/**
 * The training data and the weight of the poses as a text. Bounds can be compared only between runs of the same
 * data and weight.
 */
export function dataOf({ settings, clips }: Run): string {
  const joints = [...new Set(settings.parts.flatMap(({ joints }) => joints))].sort((a, b) => a - b);
  return JSON.stringify([
    clips.map(({ id, first, end, firstBones }) => [id, first, end, firstBones === true]),
    settings.framesPerSecond,
    joints,
    settings.poseWeight ?? 1,
  ]);
}

export interface Column {
  head: string;
  /** The meaning of the head. */
  meaning: string;
  /** The term to explain. */
  term?: TermName;
  text(run: Run): string;
  /** The whole value, when the text is shortened. */
  key(run: Run): string;
}

const count = (
  head: string,
  meaning: string,
  of: (settings: TrainingSettings) => number | string,
  term?: TermName,
): Column => {
  const text = ({ settings }: Run) => String(of(settings));
  return { head, meaning, text, key: text, ...(term && { term }) };
};

function allColumns(): Column[] {
  const { settings: words, runs } = lab().learn;
  return [
    {
      head: runs.clips,
      meaning: runs.clips,
      text: ({ clips }) => (clips.length === 1 ? (clips[0]?.title ?? "") : String(clips.length)),
      key: ({ clips }) => clips.map(({ title, first, end }) => `${title} ${first + 1}-${end}`).join(", "),
    },
    {
      head: words.parts,
      meaning: words.parts,
      text: ({ settings }) => settings.parts.map(({ name }) => shownPart(name)).join(", "),
      key: ({ settings }) =>
        settings.parts.map(({ name, joints }) => runs.joints(shownPart(name), joints.length)).join(", "),
    },
    count("Q", words.latent.label, ({ latent }) => latent, "latent-space"),
    count("K", words.dynamicsIps.label, ({ dynamicsIps }) => dynamicsIps, "dynamics-points"),
    count("L", words.poseIps.label, ({ poseIps }) => poseIps, "pose-points"),
    count("p", words.order.label, ({ order }) => order, "order"),
    count(runs.heads.framesPerSecond, words.framesPerSecond.label, ({ framesPerSecond }) => framesPerSecond),
    count(
      runs.heads.maxIterations,
      words.maxIterations.label,
      ({ maxIterations }) => maxIterations,
      "iterations",
    ),
    count(runs.heads.poseWeight, words.poseWeight.label, ({ poseWeight = 1 }) =>
      words.poseWeight.value(poseWeight),
    ),
  ];
}

/** The settings in which the runs differ, without the seed. */
export function differences(runs: readonly Run[]): Column[] {
  return allColumns().filter(({ key }) => new Set(runs.map(key)).size > 1);
}

/** The progress of one of several trainings of about the same length. */
export interface Course {
  state: Run["state"];
  /** Seconds of training. */
  elapsed: number;
  /** The share of its iterations that is done. */
  fraction: number;
}

const courseOf = ({ state, elapsed, steps }: Run): Course => ({
  state,
  elapsed,
  fraction: steps.at(-1)?.fraction ?? 0,
});

/** The share of all iterations of these runs that is done, 0 to 1. */
export const share = (runs: readonly Run[]): number => shareOf(runs.map(courseOf));

/** The remaining seconds of these runs at most, on `workers` workers; null: too early to know. */
export const secondsLeft = (runs: readonly Run[], workers: number): number | null =>
  restOf(runs.map(courseOf), workers);

/** The share of all iterations of these trainings that is done, 0 to 1. */
export function shareOf(courses: readonly Course[]): number {
  const behind = courses.map((course) => (isOver(course) ? 1 : course.fraction));
  return behind.reduce((sum, fraction) => sum + fraction, 0) / Math.max(1, courses.length);
}

/** The remaining seconds of these trainings at most, on `workers` workers; null: too early to know. */
export function restOf(courses: readonly Course[], workers: number): number | null {
  let seconds = 0;
  let done = 0;
  for (const { elapsed, fraction } of courses) {
    seconds += elapsed;
    done += fraction;
  }
  if (seconds < 1 || done <= 0.01) return null;
  const whole = seconds / done;
  const busy = courses
    .filter(({ state }) => state === "running")
    .map(({ fraction }) => whole * (1 - fraction));
  while (busy.length < workers) busy.push(0);
  for (const { state } of courses) {
    if (state !== "waiting") continue;
    // The next waiting training goes to the worker that is free first.
    const soonest = Math.min(...busy);
    busy[busy.indexOf(soonest)] = soonest + whole;
  }
  return Math.max(...busy);
}
