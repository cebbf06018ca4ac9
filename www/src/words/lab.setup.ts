// For tests: the English words of the Lab and of its views.
import { loadHelp } from "./help";
import { loadLab } from "./lab";
import { loadNumbers } from "./numbers";
import { loadSession } from "./session";
import type { WordsStore } from "./words";

const english = { language: "en", on: () => () => {} } as unknown as WordsStore;
for (const load of [loadLab, loadHelp, loadNumbers, loadSession]) await load(english);
