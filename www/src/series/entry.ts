import { defineView } from "../views/define-view";
import { words } from "./view-words";
import type { Series } from "./series";

declare module "../settings/views" {
  interface ViewStores {
    series: Series;
  }
}

export const view = defineView({
  name: "series",
  budget: 15_000,
  // Few visitors have time series.
  place: null,
  words: {
    en: {
      name: "Time series",
      lead: "Curves that are no body: which parts they have, and which part drives which.",
    },
    de: {
      name: "Zeitreihen",
      lead: "Kurven, die kein Körper sind: welche Teile sie haben, und welcher Teil welchen treibt.",
    },
  },
  async stores({ workers, settings, words: language }) {
    const [{ openSeries }] = await Promise.all([import("./series"), words.load(language)]);
    return openSeries(workers, settings);
  },
});
