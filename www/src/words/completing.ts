// The words of a recording that gives one part. They load when it is opened.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/completing")).completing,
  de: async () => (await import("./de/completing")).completing,
});

/** The words in the present language. */
export const completingWords = words.now;
export const loadCompleting = words.load;
