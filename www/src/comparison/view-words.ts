// The words of the view Compare models in the present language.
import { viewWords } from "../words/section";

export const words = viewWords({ en: () => import("./en"), de: () => import("./de") });
export const compareWords = words.now;
