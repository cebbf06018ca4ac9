// Trainings on synthetic experiments and sentences about their findings. No rendering, no worker.
import type { TrainingOutcome } from "../engine/protocol";
import type {
  Experiment,
  SyntheticFindings,
  SyntheticTruth,
  TrainedExperiment,
} from "../engine/whole-protocol";
import type { Course } from "../training/runs";
import { ratio } from "../figures/numbers";
import { experimentWords } from "./view-words";

/** A training on an experiment that waits, runs or is over. */
export interface ExperimentRun extends Experiment, Course {
  iteration: number;
  /** The findings at the best bound so far; null before the first report. */
  findings: TrainedExperiment | null;
  /** How it ended; null before, and when it failed. */
  outcome: TrainingOutcome | null;
  /** Why it failed; empty when it did not. */
  ending: string;
}

/** The seeds of the table in docs/synthetic.md. */
export const TEN_SEEDS = Array.from({ length: 10 }, (_, seed) => seed);

export function newRun({ seed, driving, points }: Experiment): ExperimentRun {
  return {
    seed,
    driving,
    points,
    state: "waiting",
    elapsed: 0,
    fraction: 0,
    iteration: 0,
    findings: null,
    outcome: null,
    ending: "",
  };
}

export const isSame = (a: Experiment, b: Experiment): boolean =>
  a.seed === b.seed && a.driving === b.driving && a.points === b.points;

/** The order: experiments with driving first, then by seed. */
export function inOrder(runs: readonly ExperimentRun[]): ExperimentRun[] {
  return [...runs].sort((a, b) => Number(b.driving) - Number(a.driving) || a.seed - b.seed);
}

/** Whether the couplings show the true direction of driving. */
export const isFound = ({ verdict }: SyntheticFindings): boolean =>
  verdict.backIsRight && verdict.forthIsRight;

/** A sentence about the couplings of each direction, and whether it is true. */
export function readings(
  { verdict }: SyntheticFindings,
  { drive, much, alike }: Pick<SyntheticTruth, "drive" | "much" | "alike">,
): { words: string; right: boolean }[] {
  const { back, forth, backIsRight, forthIsRight } = verdict;
  const words = experimentWords().verdict;
  const withoutInfluence = (source: number, target: number, right: boolean) =>
    right ? words.nothing(source, target) : words.seems(source, target, much);
  const withInfluence = () => {
    if (forthIsRight) return words.say;
    return forth > alike ? words.tooSmall(alike) : words.tooLarge;
  };
  const backWords = withoutInfluence(2, 1, backIsRight);
  const forthWords = drive > 0 ? withInfluence() : withoutInfluence(1, 2, forthIsRight);
  return [
    { words: `${words.ratio(2, 1, ratio(back))} ${backWords}`, right: backIsRight },
    { words: `${words.ratio(1, 2, ratio(forth))} ${forthWords}`, right: forthIsRight },
  ];
}

/** The result in one sentence. */
export function headline(findings: SyntheticFindings, driving: boolean): string {
  const words = experimentWords().verdict;
  if (!isFound(findings)) return words.missed;
  return driving ? words.driven : words.neither;
}

/** How often the truth was found; trainings that were stopped early do not count. */
export function tally(runs: readonly ExperimentRun[]): string {
  const words = experimentWords().verdict;
  const sentences: string[] = [];
  for (const driving of [true, false]) {
    const done = runs
      .filter((run) => run.driving === driving && run.state === "done")
      .flatMap(({ findings }) => findings ?? []);
    if (done.length > 0) sentences.push(words.tally(done.filter(isFound).length, done.length, driving));
  }
  const stopped = runs.filter(({ state }) => state === "cancelled").length;
  if (stopped > 0) sentences.push(words.notCounted(stopped));
  return sentences.join(" ");
}
