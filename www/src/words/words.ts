// The sentences of the page in the visitor's language. Only the language in use is loaded.
import { keep, kept } from "../ui/browser";
import { languageChanges } from "../ui/language";
import { Store } from "../ui/store";
import type { Words } from "./en";

export type { Words } from "./en";

export const LANGUAGES = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof LANGUAGES;

const LOAD: Record<Language, () => Promise<{ words: Words }>> = {
  en: () => import("./en"),
  de: () => import("./de"),
};

/** The name under which the browser keeps the visitor's choice. */
const KEPT = "language";

/** The language of a tag such as "de-CH"; null: the page has no such language. */
function languageOf(tag: string | null): Language | null {
  const short = tag?.slice(0, 2).toLowerCase();
  return short !== undefined && short in LANGUAGES ? (short as Language) : null;
}

/** The language that the visitor has chosen, or the first of the browser's languages that the page has. */
export function preferredLanguage(kept: string | null, tags: readonly string[]): Language {
  return [kept, ...tags].map(languageOf).find((language) => language !== null) ?? "en";
}

export class WordsStore extends Store {
  #language: Language = "en";
  #words: Words | null = null;
  /** The language that was asked for last. */
  #asked: Language = "en";

  get language(): Language {
    return this.#language;
  }

  /** The words in the present language. The page draws nothing before they have loaded. */
  get now(): Words {
    if (!this.#words) throw new Error("the words have not loaded yet");
    return this.#words;
  }

  /** Loads the words of a language and shows them. */
  async load(language: Language): Promise<void> {
    this.#asked = language;
    const { words } = await LOAD[language]();
    // The visitor may have chosen another language since.
    if (this.#asked !== language) return;
    this.#language = language;
    languageChanges.language = language;
    this.#words = words;
    document.documentElement.lang = language;
    this.changed();
  }

  /** Loads the words for this browser. */
  loadPreferred(): Promise<void> {
    return this.load(preferredLanguage(kept(KEPT), navigator.languages));
  }

  /** The visitor has chosen a language, which the browser keeps. */
  async choose(language: Language): Promise<void> {
    await this.load(language);
    keep(KEPT, language);
  }
}
