// The words of the view Who drives whom? They load with the view.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/experiment")).experiment,
  de: async () => (await import("./de/experiment")).experiment,
});

/** The words in the present language. */
export const experimentWords = words.now;
export const loadExperiment = words.load;
