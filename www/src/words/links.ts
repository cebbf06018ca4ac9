// The words about links that bring a model. They load at their first use.
import type { LinkWords } from "./en/links";
import { SectionWords } from "./section";
import type { WordsStore } from "./words";

/** The words in the language of the page; load them first. */
export const linkWords = (words: WordsStore) =>
  new SectionWords<LinkWords>(words, { en: () => import("./en/links"), de: () => import("./de/links") });
