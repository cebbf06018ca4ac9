// For tests: the English words of the Lab.
import { loadLab } from "./lab";
import type { WordsStore } from "./words";

await loadLab({ language: "en", on: () => () => {} } as unknown as WordsStore);
