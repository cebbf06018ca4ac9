import { Store } from "./store";

class LanguageChanges extends Store {
  tell(): void {
    this.changed();
  }
}

/** Redraws all views when the words of the page are those of another language. */
export const languageChanges = new LanguageChanges();
