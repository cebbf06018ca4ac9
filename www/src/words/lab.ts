// The words of the Lab. They load with the Lab, and again in another language.
import { languageChanges } from "../ui/language";
import type { LabWords } from "./en/lab";
import type { Language, WordsStore } from "./words";

export type { LabWords } from "./en/lab";

const LOAD: Record<Language, () => Promise<{ lab: LabWords }>> = {
  en: () => import("./en/lab"),
  de: () => import("./de/lab"),
};

let now: LabWords | null = null;

/** The words in the present language. The Lab is drawn after they have loaded. */
export function lab(): LabWords {
  if (now === null) throw new Error("the words of the Lab have not loaded yet");
  return now;
}

/** Loads the words, from now on in each language of the page. */
export async function loadLab(words: WordsStore): Promise<void> {
  await follow(words);
  // The words before stay where the new ones cannot be loaded.
  words.on(() => void follow(words).catch(() => {}));
}

async function follow(words: WordsStore): Promise<void> {
  const { language } = words;
  const { lab } = await LOAD[language]();
  if (words.language !== language || lab === now) return;
  now = lab;
  languageChanges.tell();
}
