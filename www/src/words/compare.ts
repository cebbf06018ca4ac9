// The words of the view Compare models. They load with the comparisons.
import { viewWords } from "./section";

export type { CompareWords } from "./en/compare";

const words = viewWords({
  en: async () => (await import("./en/compare")).compare,
  de: async () => (await import("./de/compare")).compare,
});

/** The words in the present language. */
export const compareWords = words.now;
export const loadCompare = words.load;
