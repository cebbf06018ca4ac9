// The words of the view Time series. They load with the view.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/series")).series,
  de: async () => (await import("./de/series")).series,
});

/** The words in the present language. */
export const seriesWords = words.now;
export const loadSeries = words.load;
