// The words of the view Which is natural? They load with its store.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/perception")).perception,
  de: async () => (await import("./de/perception")).perception,
});

/** The words in the present language. */
export const perceptionWords = words.now;
export const loadPerception = words.load;
