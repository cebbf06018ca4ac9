import { Store } from "./store";

class LanguageChanges extends Store {
  /** The language of the words, in which numbers are written too. */
  language = "en";

  tell(): void {
    this.changed();
  }
}

/** Redraws all views when the words of the page are those of another language. */
export const languageChanges = new LanguageChanges();
