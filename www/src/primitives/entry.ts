import { defineView } from "../views/define-view";
import type { Primitives } from "./primitives";
import { words } from "./view-words";
import { loadCompleting } from "../words/sections";

declare module "../settings/views" {
  interface ViewStores {
    primitives: Primitives;
  }
}

export const view = defineView({
  name: "primitives",
  budget: 113_000,
  place: 2,
  words: {
    en: {
      name: "Primitives",
      lead: "Parts learned once, put together in new ways: legs of one movement, arms of another.",
    },
    de: {
      name: "Primitive",
      lead: "Teile, einmal gelernt und neu zusammengesetzt: Beine einer Bewegung, Arme einer anderen.",
    },
  },
  async stores(page) {
    const [{ openPrimitives }] = await Promise.all([
      import("./primitives"),
      words.load(page.words),
      loadCompleting(page.words),
    ]);
    const primitives = openPrimitives(page.workers, page.engine, page.settings, page.clips, page.notices);
    primitives.library.on(page.touched);
    return primitives;
  },
});
