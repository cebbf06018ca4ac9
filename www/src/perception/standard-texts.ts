// The texts that participants read. A study that nobody has edited has the standard texts in English; the page
// shows these in its own language, and the file of the study keeps them as they are.
import type { StudyTexts } from "../engine/whole-protocol";
import { study as english } from "./study-en";
import { perceptionWords } from "./view-words";

const inOther = (text: string, from: readonly string[], to: readonly string[]) =>
  to[from.indexOf(text)] ?? text;

/** The text of this name in the language of the page, if it is a standard text; else as it is. */
export const shownText = (name: keyof StudyTexts, text: string): string =>
  inOther(text, english[name], perceptionWords().standard[name]);

/** The text as a study stores it: a standard text in English. */
export const storedText = (name: keyof StudyTexts, text: string): string =>
  inOther(text, perceptionWords().standard[name], english[name]);
