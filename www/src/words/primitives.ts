// The words of the view Primitives. They load with its stores.
import { viewWords } from "./section";

const words = viewWords({
  en: async () => (await import("./en/primitives")).primitives,
  de: async () => (await import("./de/primitives")).primitives,
});

/** The words in the present language. */
export const primitivesWords = words.now;
export const loadPrimitives = words.load;
