// The words of a part of the page that few visitors open. They load at their first use, in the page's language.
import { languageChanges } from "../ui/language";
import { Store } from "../ui/store";
import type { Language, WordsStore } from "./words";

/** The files with the words, one for each language. */
type Files<Section> = Readonly<Record<Language, () => Promise<{ readonly words: Section }>>>;

export class SectionWords<Section> extends Store {
  readonly #words: WordsStore;
  #now: Section | null = null;
  #language: Language | null = null;

  constructor(
    words: WordsStore,
    private readonly files: Files<Section>,
  ) {
    super();
    this.#words = words;
    // The words before stay where the new ones cannot be loaded.
    words.on(() => void this.load().catch(() => {}));
  }

  /** The words, in the language of the page or, while that loads, in the one before. */
  get now(): Section {
    if (this.#now === null) throw new Error("these words have not loaded yet");
    return this.#now;
  }

  get loaded(): boolean {
    return this.#now !== null;
  }

  async load(): Promise<void> {
    const { language } = this.#words;
    if (language === this.#language) return;
    const { words } = await this.files[language]();
    if (this.#words.language !== language) return;
    [this.#now, this.#language] = [words, language];
    this.changed();
  }
}

/** The words of a view, which load before the view. All views are drawn again in another language. */
export function viewWords<Section>(files: Files<Section>) {
  let section: SectionWords<Section> | null = null;
  return {
    now(): Section {
      if (!section) throw new Error("these words have not loaded yet");
      return section.now;
    },
    /** The words; null: they have not loaded yet. */
    ifLoaded: (): Section | null => (section?.loaded ? section.now : null),
    /** Gives the words to `use`; in the story they load first, in the language of the document. */
    soon(use: (words: Section) => void): void {
      if (section?.loaded) {
        use(section.now);
        return;
      }
      const language = document.documentElement.lang === "de" ? "de" : "en";
      void files[language]().then(({ words }) => use(words));
    },
    async load(words: WordsStore): Promise<void> {
      if (!section) {
        section = new SectionWords(words, files);
        section.on(() => languageChanges.tell());
      }
      await section.load();
    },
  };
}
