// The sentences of the page in the visitor's language. Only the language in use is loaded.
import { Store } from "../ui/store";
import type { Words } from "./en";

export type { Words } from "./en";

export const LANGUAGES = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof LANGUAGES;

const LOAD: Record<Language, () => Promise<{ words: Words }>> = {
  en: () => import("./en"),
  de: () => import("./de"),
};

/** The key of the visitor's choice in the browser's storage. */
const KEPT = "vcgpdm language";

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
    this.#words = words;
    document.documentElement.lang = language;
    this.changed();
  }

  /** Loads the words for this browser. */
  loadPreferred(): Promise<void> {
    return this.load(preferredLanguage(keptLanguage(), navigator.languages));
  }

  /** The visitor has chosen a language, which the browser keeps. */
  async choose(language: Language): Promise<void> {
    await this.load(language);
    try {
      localStorage.setItem(KEPT, language);
    } catch {
      // A browser that stores nothing shows its own language at the next visit.
    }
  }
}

function keptLanguage(): string | null {
  try {
    return localStorage.getItem(KEPT);
  } catch {
    return null;
  }
}
