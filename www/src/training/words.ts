// Words for what a training does and how it ended.
import type { TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { bestBound, endOfMotion, type Run } from "./runs";

const PHASES: Record<TrainingProgress["phase"], string> = {
  "couplings-kernels-inducing-points": "couplings, kernels and inducing points",
  everything: "everything together",
};

const ENDINGS: Record<NonNullable<TrainingProgress["reason"]>, string> = {
  settled: "the bound no longer rises",
  iterations: "all iterations used",
};

export function phaseWords(phase: TrainingProgress["phase"]): string {
  return PHASES[phase];
}

/** How a run ended whose page was left. */
export const LEFT = "You left the page; this is the best so far.";
export const STOPPED = "You cancelled; this is the best so far.";

export function endingWords({ cancelled, reason }: TrainingOutcome): string {
  if (cancelled) return STOPPED;
  return reason ? ENDINGS[reason] : "Done.";
}

/** What became of several runs. `best` is the one that was put on the stage when they were over. */
export function endingOfRuns(runs: readonly Run[], best: Run | null): { words: string; failed: boolean } {
  const failed = runs.filter(({ state }) => state === "failed");
  const [first] = runs;
  if (failed[0] && failed.length === runs.length) return { words: failed[0].ending, failed: true };
  if (first && runs.length === 1) return { words: first.ending, failed: false };
  const count = (state: Run["state"]) => runs.filter((run) => run.state === state).length;
  const counts = (["done", "cancelled", "failed"] as const)
    .filter((state) => count(state) > 0)
    .map((state) => `${count(state)} ${state}`);
  const soFar = count("cancelled") > 0 ? " so far" : "";
  const shown = best ? ` The best${soFar}, seed ${best.settings.seed}, is on the stage${whyShown(best, runs)}.` : "";
  return { words: `${counts.join(", ")}.${shown}`, failed: false };
}

/** Why this run is on the stage where another has a higher bound. */
function whyShown(best: Run, runs: readonly Run[]): string {
  const higher = runs.find((run) => run.model !== null && run.state !== "failed" && bestBound(run) > bestBound(best));
  const ends = higher ? endOfMotion(higher) : "";
  if (!higher || !ends) return "";
  return `: it ${endOfMotion(best) || "keeps moving"}, while seed ${higher.settings.seed}, of a higher bound, ${ends}`;
}
