import { defineView } from "../views/define-view";
import { words } from "./view-words";

declare module "../settings/views" {
  interface ViewStores {
    method: null;
  }
}

export const view = defineView({
  name: "method",
  budget: 14_000,
  place: 5,
  words: {
    en: {
      name: "Method",
      lead: "The model in equations, and where each symbol is to be seen.",
    },
    de: {
      name: "Methode",
      lead: "Das Modell in Gleichungen, und wo jedes Zeichen zu sehen ist.",
    },
  },
  async stores(page) {
    await words.load(page.words);
    return null;
  },
});
