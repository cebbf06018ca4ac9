// The words of the view Draw in the present language.
import { viewWords } from "./section";

export const words = viewWords({ en: () => import("./en/drawing"), de: () => import("./de/drawing") });
export const drawingWords = words.now;
