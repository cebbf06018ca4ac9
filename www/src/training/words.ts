// Texts about a training: the time left, and its end.
import type { Setbacks, TrainingOutcome, TrainingProgress } from "../engine/protocol";
import { duration, sentence } from "../ui/format";
import { lab } from "../words/lab";
import { bestBound, dataOf, endOfMotion, type Run } from "./runs";

/** How a run ended, with the setbacks of its last step. */
export function endingWords(
  { cancelled, reason, notices = [] }: TrainingOutcome,
  last?: TrainingProgress,
): string {
  const { ending } = lab().learn;
  const words = cancelled ? ending.stopped : reason ? ending[reason] : ending.done;
  const setbacks = last ? setbackWords(last.setbacks) : "";
  const more = [...notices.map(sentence), setbacks].filter(Boolean).join(" ");
  return more ? `${sentence(words)} ${more}` : words;
}

function setbackWords({ jittered, turnedBack }: Setbacks): string {
  const { ending } = lab().learn;
  return [jittered > 0 ? ending.jittered(jittered) : "", turnedBack > 0 ? ending.turnedBack(turnedBack) : ""]
    .filter(Boolean)
    .join(" ");
}

/** How several runs ended. `best`: the run that took the stage. */
export function endingOfRuns(runs: readonly Run[], best: Run | null): { words: string; failed: boolean } {
  const { ending } = lab().learn;
  const failed = runs.filter(({ state }) => state === "failed");
  const [first] = runs;
  if (failed[0] && failed.length === runs.length) return { words: failed[0].ending, failed: true };
  if (first && runs.length === 1) return { words: first.ending, failed: false };
  const count = (state: Run["state"]) => runs.filter((run) => run.state === state).length;
  const counts = (["done", "cancelled", "failed"] as const)
    .filter((state) => count(state) > 0)
    .map((state) => ending.count(count(state), state));
  const shown = best
    ? `${ending.best(best.settings.seed, count("cancelled") > 0)}${reasonToShow(best, runs)}.`
    : "";
  return { words: `${counts.join(", ")}.${shown}`, failed: false };
}

/** Why this run is on the stage although another of the same data has a higher objective. */
function reasonToShow(best: Run, runs: readonly Run[]): string {
  const alike = runs.filter((run) => dataOf(run) === dataOf(best));
  const trained = alike.filter((run) => run.model !== null && run.state !== "failed");
  const higher = trained.find((run) => bestBound(run) > bestBound(best));
  if (!higher) return "";
  const { ending } = lab().learn;
  const { seed } = higher.settings;
  const ends = endOfMotion(higher);
  return ends ? ending.worse(endOfMotion(best) || ending.keepsMoving, seed, ends) : ending.closer(seed);
}

/** The remaining time, rounded so that it does not flicker; null: not known yet. */
export function timeLeft(left: number | null, about = false): string {
  const words = lab().learn.training;
  if (left === null) return words.estimating;
  const step = left > 60 ? 10 : left > 20 ? 5 : 1;
  const time = duration(Math.max(1, Math.ceil(left / step) * step));
  return about ? words.leftAbout(time) : words.left(time);
}
