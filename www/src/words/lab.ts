// The words of the Lab. They load with the Lab.
import { viewWords } from "./section";

export type { LabWords } from "./en/lab";
export type { LearnWords } from "./en/learn";

const words = viewWords({ en: () => import("./en/lab"), de: () => import("./de/lab") });

/** The words in the present language. */
export const lab = words.now;
/** For notices that the story may show too, where the words may not have loaded yet. */
export const withLab = words.soon;
export const loadLab = words.load;

const nameIn = (names: Readonly<Record<string, string>>, key: string, other: string): string =>
  (Object.hasOwn(names, key) ? names[key] : undefined) ?? other;

/** The name of a part as the page shows it. The names of the library's own splits have a translation. */
export const shownPart = (name: string): string => nameIn(lab().partNames, name, name);

/** The title of a split of the body into parts as the page shows it. `id`: that of the library's own split. */
export const shownSplit = ({ id, title }: { id: string; title: string }): string =>
  nameIn(lab().splits, id, title);
