// What the story says to a guess: right, wrong, or right for another question. Loads with the first guess.
import { viewWords } from "./section";

export type { Replies } from "./en/replies";

const words = viewWords({
  en: async () => (await import("./en/replies")).replies,
  de: async () => (await import("./de/replies")).replies,
});

/** The replies by chapter and answer; null: they have not loaded. */
export const repliesNow = words.ifLoaded;
export const loadReplies = words.load;
