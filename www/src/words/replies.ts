// What the story says to a guess: right, wrong, or right for another question. Loads with the first guess.
import { viewWords } from "./section";

export type { Replies } from "./en/replies";
import type { WordsStore } from "./words";

const words = viewWords({
  en: async () => (await import("./en/replies")).replies,
  de: async () => (await import("./de/replies")).replies,
});
let isLoaded = false;

/** The replies by chapter and answer; null: they have not loaded. */
export const repliesNow = () => (isLoaded ? words.now() : null);

export async function loadReplies(store: WordsStore): Promise<void> {
  await words.load(store);
  isLoaded = true;
}
