// For tests: the English words of the Lab and of its views.
import { loadLab } from "./lab";
import { loadHelp, loadNumbers, loadSession } from "./sections";
import type { WordsStore } from "./words";

type ViewWords = { load(words: WordsStore): Promise<void> };
const english = { language: "en", on: () => () => {} } as unknown as WordsStore;
const ofViews = import.meta.glob<ViewWords>("../*/view-words.ts", { eager: true, import: "words" });
for (const { load } of Object.values(ofViews)) await load(english);
for (const load of [loadLab, loadHelp, loadNumbers, loadSession]) await load(english);
