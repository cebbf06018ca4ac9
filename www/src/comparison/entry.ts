import { defineView } from "../views/define-view";
import type { ComparisonStore } from "./comparison-store";
import { words } from "./view-words";

declare module "../settings/views" {
  interface ViewStores {
    compare: ComparisonStore;
  }
}

export const view = defineView({
  name: "compare",
  budget: 88_000,
  place: 1,
  words: {
    en: {
      name: "Compare models",
      lead: "Which model foresees a walk best, and what does it cost?",
    },
    de: {
      name: "Modelle vergleichen",
      lead: "Welches Modell sieht einen Gang am besten voraus, und was kostet es?",
    },
  },
  async stores(page) {
    const [{ ComparisonStore }] = await Promise.all([import("./comparison-store"), words.load(page.words)]);
    const comparison = new ComparisonStore(page.engine, page.settings, page.clips, page.workers);
    comparison.on(page.touched);
    return comparison;
  },
});
