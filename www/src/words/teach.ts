// The words of the page for teachers, of the slides and of the exercises.
import type { TeachWords } from "./en/teach";
import { SectionWords } from "./section";
import type { WordsStore } from "./words";

export type { TeachWords } from "./en/teach";

/** The words in the language of the page; load them first. */
export const teachWords = (words: WordsStore) =>
  new SectionWords<TeachWords>(words, { en: () => import("./en/teach"), de: () => import("./de/teach") });
