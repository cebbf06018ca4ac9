import { defineView } from "../views/define-view";
import { words } from "./view-words";
import type { DrawingStore } from "./drawing-store";

declare module "../settings/views" {
  interface ViewStores {
    draw: DrawingStore;
  }
}

export const view = defineView({
  name: "draw",
  budget: 15_000,
  place: 0,
  words: {
    en: { name: "Draw", lead: "Draw with one hand or with two: a model goes on as your hand did." },
    de: {
      name: "Zeichnen",
      lead: "Zeichne mit einer Hand oder mit zweien: Ein Modell macht weiter wie deine Hand.",
    },
  },
  async stores({ workers, settings, words: language }) {
    const [{ DrawingStore, linkDrawings }] = await Promise.all([
      import("./drawing-store"),
      words.load(language),
    ]);
    const store = new DrawingStore(workers);
    linkDrawings(store, settings, () => import("./link"));
    return store;
  },
});
