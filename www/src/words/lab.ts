// The words of the Lab. They load with the Lab.
import { viewWords } from "./section";

export type { LabWords } from "./en/lab";
export type { LearnWords } from "./en/learn";

const words = viewWords({
  en: async () => (await import("./en/lab")).lab,
  de: async () => (await import("./de/lab")).lab,
});

/** The words in the present language. */
export const lab = words.now;
/** For notices that the story may show too, where the words may not have loaded yet. */
export const withLab = words.soon;
export const loadLab = words.load;
