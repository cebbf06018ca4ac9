// The rounds of the riddle: which experiment is shown, and what a model believes about it.
import type { Experiment, SyntheticFindings } from "../../engine/whole-protocol";
import { SETTINGS } from "../../settings/settings";

/** Who drives whom on the screen, where A is on the left. */
export type Answer = "ab" | "ba" | "none";
export type Belief = Answer | "both";

/** An experiment with its true answer. `isMirrored`: part 1 of the experiment is B. */
export interface Round {
  experiment: Experiment;
  isMirrored: boolean;
  truth: Answer;
}

/** The seeds whose results docs/synthetic.md lists. */
const SEEDS = 10;

/** In three rounds each answer is right once; `random` gives numbers from 0 to 1. */
export function threeRounds(random: () => number): Round[] {
  const rounds = (["ab", "ba", "none"] as const).map((truth): Round => {
    const seed = Math.floor(random() * SEEDS);
    const experiment = { seed, driving: truth !== "none", points: SETTINGS.drawnPoints.initial };
    const isMirrored = truth === "none" ? random() < 0.5 : truth === "ba";
    return { experiment, isMirrored, truth };
  });
  const order = new Map(rounds.map((round) => [round, random()]));
  return rounds.sort((a, b) => (order.get(a) ?? 0) - (order.get(b) ?? 0));
}

/** The couplings of the findings as A and B, in units of what each part has to say about itself. */
export function ratiosOf({ verdict: { forth, back } }: Pick<SyntheticFindings, "verdict">, round: Round) {
  return round.isMirrored ? { ab: back, ba: forth } : { ab: forth, ba: back };
}

/** What the couplings say. From `much` times its own variance on, the other part has no say. */
export function beliefOf({ ab, ba }: { ab: number; ba: number }, much: number): Belief {
  if (ab < much && ba < much) return "both";
  if (ab < much) return "ab";
  return ba < much ? "ba" : "none";
}
