import { defineView } from "../views/define-view";
import type { ExperimentStore } from "./experiment-store";
import { words } from "./view-words";

declare module "../settings/views" {
  interface ViewStores {
    synthetic: ExperimentStore;
  }
}

export const view = defineView({
  name: "synthetic",
  budget: 16_000,
  place: 3,
  words: {
    en: {
      name: "Who drives whom?",
      lead: "Two made-up systems of which the truth is known: does training find it?",
    },
    de: {
      name: "Wer treibt wen?",
      lead: "Zwei erdachte Systeme, deren Wahrheit bekannt ist: Findet das Training sie?",
    },
  },
  async stores({ settings, workers, words: language }) {
    const [{ ExperimentStore }] = await Promise.all([import("./experiment-store"), words.load(language)]);
    return new ExperimentStore(settings, workers);
  },
});
