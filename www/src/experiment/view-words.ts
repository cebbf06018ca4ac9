// The words of the view Who drives whom? in the present language.
import { viewWords } from "../words/section";

export const words = viewWords({ en: () => import("./en"), de: () => import("./de") });
export const experimentWords = words.now;
