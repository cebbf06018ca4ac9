// Words for what a training does and how it ended.
import type { TrainingOutcome, TrainingProgress } from "../engine/protocol";

export function phaseWords(phase: TrainingProgress["phase"]): string {
  return phase;
}

export function endingWords({ cancelled, reason }: TrainingOutcome): string {
  return cancelled ? "You cancelled; this is the best so far." : (reason ?? "Done.");
}
