// The synthetic experiment: what was tried, how far it is, and what it found, in words. No rendering, no worker.
import { grouped } from "../ui/format";
import type { ExperimentJob, SyntheticFindings, SyntheticTruth } from "../engine/whole-protocol";
import type { Course } from "../training/runs";

/** One training: asked for, under way or over. */
export interface Try extends ExperimentJob, Course {
  iteration: number;
  /** At the best bound so far; null before the first report. */
  findings: SyntheticFindings | null;
  /** How it ended, in plain words. */
  ending: string;
}

/** The seeds of the table in docs/synthetic.md. */
export const TEN_SEEDS = Array.from({ length: 10 }, (_, seed) => seed);

export function newTry({ seed, driving }: ExperimentJob): Try {
  return { seed, driving, state: "waiting", elapsed: 0, fraction: 0, iteration: 0, findings: null, ending: "" };
}

export const isSame = (a: ExperimentJob, b: ExperimentJob): boolean => a.seed === b.seed && a.driving === b.driving;

/** With driving first, then by seed. */
export function inOrder(tries: readonly Try[]): Try[] {
  return [...tries].sort((a, b) => Number(b.driving) - Number(a.driving) || a.seed - b.seed);
}

/** Whether the couplings say the truth about who drives whom. */
export const isFound = ({ verdict }: SyntheticFindings): boolean => verdict.backIsRight && verdict.forthIsRight;

/** A ratio of two coupling variances. */
export function times(ratio: number): string {
  return ratio >= 100 ? grouped(ratio) : ratio >= 10 ? ratio.toFixed(1) : ratio.toFixed(2);
}

/** What the couplings say of each direction, and whether it is true. */
export function readings(
  { verdict }: SyntheticFindings,
  { drive, much, alike }: Pick<SyntheticTruth, "drive" | "much" | "alike">,
): { words: string; right: boolean }[] {
  const { back, forth, backIsRight, forthIsRight } = verdict;
  const none = (is: string, source: number, target: number, right: boolean) =>
    `${is}: part ${source} ${
      right
        ? `counts for nothing in part ${target}. That is true.`
        : `seems to have a say in part ${target}, which it has not; ${much} times or more would say so.`
    }`;
  const some = (is: string) => {
    if (forthIsRight) return `${is}: part 1 has a say in part 2. That is true.`;
    return forth > alike
      ? `${is}: too small a say of part 1 in part 2; up to ${alike} times counts as found.`
      : `${is}: part 1 seems to have more say in part 2 than part 2 itself, which is not so.`;
  };
  const backIs = `α from 2 to 1 is ${times(back)} times α from 1 to 1`;
  const forthIs = `α from 1 to 2 is ${times(forth)} times α from 2 to 2`;
  return [
    { words: none(backIs, 2, 1, backIsRight), right: backIsRight },
    { words: drive > 0 ? some(forthIs) : none(forthIs, 1, 2, forthIsRight), right: forthIsRight },
  ];
}

/** The answer in one sentence. */
export function headline(findings: SyntheticFindings, driving: boolean): string {
  if (!isFound(findings)) return "Missed: not all that the couplings say is true.";
  return driving
    ? "Found: part 1 drives part 2, and part 2 does not drive part 1."
    : "Found: neither part drives the other.";
}

/** How often the truth was found; trainings that were stopped early do not count. */
export function tally(tries: readonly Try[]): string {
  const sentences: string[] = [];
  for (const driving of [true, false]) {
    const done = tries.filter((one) => one.driving === driving && one.state === "done" && one.findings);
    if (done.length === 0) continue;
    const found = done.filter(({ findings }) => isFound(findings!)).length;
    const seeds = `${found} of ${done.length} ${done.length === 1 ? "seed" : "seeds"}`;
    sentences.push(driving ? `Found with ${seeds}.` : `Without driving, found with ${seeds}.`);
  }
  const stopped = tries.filter(({ state }) => state === "cancelled").length;
  if (stopped > 0) sentences.push(`${stopped} stopped early, not counted.`);
  return sentences.join(" ");
}
