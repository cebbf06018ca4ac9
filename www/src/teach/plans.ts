// The plans of a lecture: what is done for how many minutes. The words are in `words/*/teach`.
import { keep, kept } from "../ui/browser";
import type { TeachWords } from "../words/sections";

export type Step = keyof TeachWords["steps"];

/** What a lecturer has at hand for a step. */
export interface StepWords {
  readonly say: string;
  readonly wrong: string;
  /** The answer to the question of a chapter. */
  readonly answer?: string;
  /** Likely questions with their answers. */
  readonly asked?: readonly (readonly string[])[];
}

export const PLANS = {
  45: [
    ["hand", 5],
    ["arms", 10],
    ["loop", 6],
    ["gaussian", 5],
    ["next", 6],
    ["product", 6],
    ["borrow", 5],
    ["questions", 2],
  ],
  90: [
    ["hand", 5],
    ["arms", 10],
    ["loop", 7],
    ["gaussian", 6],
    ["next", 7],
    ["points", 6],
    ["product", 6],
    ["push", 5],
    ["borrow", 6],
    ["belief", 10],
    ["end", 2],
    ["exercises", 10],
    ["compare", 5],
    ["questions", 5],
  ],
} as const satisfies Record<number, readonly (readonly [Step, number])[]>;

export type PlanLength = keyof typeof PLANS;

/** The steps with the minutes at which they begin and end. */
export function timesOf(length: PlanLength): { step: Step; from: number; to: number }[] {
  let to = 0;
  return PLANS[length].map(([step, minutes]) => {
    const from = to;
    to += minutes;
    return { step, from, to };
  });
}

/** The name under which the browser keeps the length of the plan. */
const KEPT = "plan";

/** The plan that the lecturer has chosen. */
export const lengthOfPlan = (): PlanLength => (kept(KEPT) === "90" ? 90 : 45);
export const keepLength = (length: PlanLength): void => keep(KEPT, String(length));
