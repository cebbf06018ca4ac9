// The plans of a lecture: what is done for how many minutes. The words are in `words/*/teach`.
import type { Words } from "../words/words";
import type { TeachWords } from "../words/teach";

export type Step = keyof TeachWords["steps"];
type ChapterName = keyof Words["chapters"];

export const PLANS = {
  45: [
    ["computer", 5],
    ["arms", 10],
    ["loop", 7],
    ["next", 8],
    ["product", 6],
    ["borrow", 6],
    ["questions", 3],
  ],
  90: [
    ["computer", 5],
    ["arms", 10],
    ["loop", 7],
    ["next", 8],
    ["points", 6],
    ["product", 6],
    ["push", 5],
    ["borrow", 6],
    ["belief", 10],
    ["exercises", 17],
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

/** The number of a chapter, from 1; 0: the step is no chapter. */
export const chapterOf = (words: Words, step: Step): number =>
  (Object.keys(words.chapters) as ChapterName[]).indexOf(step as ChapterName) + 1;
