// The words of the view Draw in the present language.
import { viewWords } from "../words/section";

export const words = viewWords({ en: () => import("./en"), de: () => import("./de") });
export const drawingWords = words.now;
