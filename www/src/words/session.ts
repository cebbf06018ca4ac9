// The words about earlier visits. They load with the stored visits.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/session")).session,
  de: async () => (await import("./de/session")).session,
});

/** The words in the present language. */
export const sessionWords = words.now;
export const loadSession = words.load;
