// Trainings on synthetic experiments and sentences about their findings. No rendering, no worker.
import type { TrainingOutcome } from "../engine/protocol";
import type { Experiment, SyntheticFindings, SyntheticTruth } from "../engine/whole-protocol";
import type { Course } from "../training/runs";
import { ratio } from "../figures/numbers";

/** A training on an experiment that waits, runs or is over. */
export interface ExperimentRun extends Experiment, Course {
  iteration: number;
  /** The findings at the best bound so far; null before the first report. */
  findings: SyntheticFindings | null;
  /** How it ended; null before, and when it failed. */
  outcome: TrainingOutcome | null;
  /** Why it failed; empty when it did not. */
  ending: string;
}

/** The seeds of the table in docs/synthetic.md. */
export const TEN_SEEDS = Array.from({ length: 10 }, (_, seed) => seed);

export function newRun({ seed, driving }: Experiment): ExperimentRun {
  return {
    seed,
    driving,
    state: "waiting",
    elapsed: 0,
    fraction: 0,
    iteration: 0,
    findings: null,
    outcome: null,
    ending: "",
  };
}

export const isSame = (a: Experiment, b: Experiment): boolean => a.seed === b.seed && a.driving === b.driving;

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
  const withoutInfluence = (source: number, target: number, right: boolean) =>
    `part ${source} ${
      right
        ? `counts for nothing in part ${target}. That is true.`
        : `seems to have a say in part ${target}, which it has not; ${much} times or more would say so.`
    }`;
  const withInfluence = () => {
    if (forthIsRight) return "part 1 has a say in part 2. That is true.";
    return forth > alike
      ? `too small a say of part 1 in part 2; up to ${alike} times counts as found.`
      : "part 1 seems to have more say in part 2 than part 2 itself, which is not so.";
  };
  const backWords = withoutInfluence(2, 1, backIsRight);
  const forthWords = drive > 0 ? withInfluence() : withoutInfluence(1, 2, forthIsRight);
  return [
    { words: `α from 2 to 1 is ${ratio(back)} times α from 1 to 1: ${backWords}`, right: backIsRight },
    { words: `α from 1 to 2 is ${ratio(forth)} times α from 2 to 2: ${forthWords}`, right: forthIsRight },
  ];
}

/** The result in one sentence. */
export function headline(findings: SyntheticFindings, driving: boolean): string {
  if (!isFound(findings)) return "Missed: not all that the couplings say is true.";
  return driving
    ? "Found: part 1 drives part 2, and part 2 does not drive part 1."
    : "Found: neither part drives the other.";
}

/** How often the truth was found; trainings that were stopped early do not count. */
export function tally(runs: readonly ExperimentRun[]): string {
  const sentences: string[] = [];
  for (const driving of [true, false]) {
    const done = runs
      .filter((run) => run.driving === driving && run.state === "done")
      .flatMap(({ findings }) => findings ?? []);
    if (done.length === 0) continue;
    const seeds = `${done.filter(isFound).length} of ${done.length} ${done.length === 1 ? "seed" : "seeds"}`;
    sentences.push(driving ? `Found with ${seeds}.` : `Without driving, found with ${seeds}.`);
  }
  const stopped = runs.filter(({ state }) => state === "cancelled").length;
  if (stopped > 0) sentences.push(`${stopped} stopped early, not counted.`);
  return sentences.join(" ");
}
