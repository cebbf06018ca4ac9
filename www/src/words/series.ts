// The words of the view Time series in the present language.
import { viewWords } from "./section";

export const words = viewWords({ en: () => import("./en/series"), de: () => import("./de/series") });
export const seriesWords = words.now;
