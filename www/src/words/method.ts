// The words of the view Method. They load with the view.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/method")).method,
  de: async () => (await import("./de/method")).method,
});

/** The words in the present language. */
export const methodWords = words.now;
export const loadMethod = words.load;
