// The words of the tab Numbers. They load with the tab.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/numbers")).numbers,
  de: async () => (await import("./de/numbers")).numbers,
});

/** The words in the present language. */
export const numbers = words.now;
export const loadNumbers = words.load;
