// For tests: the English words of the Lab and of its views.
import { loadLab } from "./lab";
import { loadHelp, loadNumbers, loadSession } from "./sections";
import { words as series } from "./series";
import type { WordsStore } from "./words";

const english = { language: "en", on: () => () => {} } as unknown as WordsStore;
const ofViews = import.meta.glob<typeof series>("../*/view-words.ts", { eager: true, import: "words" });
for (const { load } of [...Object.values(ofViews), series]) await load(english);
for (const load of [loadLab, loadHelp, loadNumbers, loadSession]) await load(english);
