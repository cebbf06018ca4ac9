// The words of the view Which is natural? in the present language.
import { viewWords } from "../words/section";

export const words = viewWords({ en: () => import("./en"), de: () => import("./de") });
export const perceptionWords = words.now;
