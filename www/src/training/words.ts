// Texts about a training: its phases and its end.
import type { Setbacks, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { sentence } from "../ui/format";
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

/** The models that trainings would make; `made`: all their clips are samples. */
export function newModelWords(trainings: number, clips: number, made: boolean): string {
  const models = trainings === 1 ? "A new model" : `${trainings} new models`;
  const sample = made ? "sample " : "";
  const of =
    clips === 1 ? `ticked ${sample}clip and its body` : `${clips} ticked ${sample}clips and their body`;
  return `${models}, of the ${of}.`;
}

/** The end of a run whose page was left. */
export const LEFT = "You left the page; this is the best so far.";
export const STOPPED = "You cancelled; this is the best so far.";

/** How a run ended, with the setbacks of its last step. */
export function endingWords(
  { cancelled, reason, notices = [] }: TrainingOutcome,
  last?: TrainingProgress,
): string {
  const words = cancelled ? STOPPED : reason ? ENDINGS[reason] : "Done.";
  const setbacks = last ? setbackWords(last.setbacks) : "";
  const more = [...notices.map(sentence), setbacks].filter(Boolean).join(" ");
  return more ? `${sentence(words)} ${more}` : words;
}

function setbackWords({ jittered, turnedBack }: Setbacks): string {
  const times = (count: number) => (count === 1 ? "once" : `${count} times`);
  const jitter = `A covariance needed jitter on its diagonal ${times(jittered)}.`;
  const back = `The search turned back ${times(turnedBack)} where there was no finite number.`;
  return [jittered > 0 ? jitter : "", turnedBack > 0 ? back : ""].filter(Boolean).join(" ");
}

/** How several runs ended. `best`: the run that took the stage. */
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
  const shown = best
    ? ` The best${soFar}, seed ${best.settings.seed}, is on the stage${reasonToShow(best, runs)}.`
    : "";
  return { words: `${counts.join(", ")}.${shown}`, failed: false };
}

/** Why this run is on the stage although another has a higher bound. */
function reasonToShow(best: Run, runs: readonly Run[]): string {
  const higher = runs.find(
    (run) => run.model !== null && run.state !== "failed" && bestBound(run) > bestBound(best),
  );
  if (!higher) return "";
  const ends = endOfMotion(higher);
  if (!ends)
    return `: its motion is closer to the clips than that of seed ${higher.settings.seed}, of a higher bound`;
  return `: it ${endOfMotion(best) || "keeps moving"}, while seed ${higher.settings.seed}, of a higher bound, ${ends}`;
}
