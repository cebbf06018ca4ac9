// The words of the help. They load with it.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/help")).help,
  de: async () => (await import("./de/help")).help,
});

/** The words in the present language. */
export const helpWords = words.now;
export const loadHelp = words.load;
