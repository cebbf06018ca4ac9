// The words of the view Time series in the present language.
import { viewWords } from "../words/section";

export const words = viewWords({ en: () => import("./en"), de: () => import("./de") });
export const seriesWords = words.now;
