import type { SessionWords } from "../en/session";

const counted = (count: number, singular: string, plural: string) =>
  count === 1 ? singular : `${count} ${plural}`;

export const words: SessionWords = {
  clips: (count) => counted(count, "ein Clip", "Clips"),
  runs: (count) => counted(count, "ein Training", "Trainings"),
  models: (count) => counted(count, "ein Modell", "Modelle"),
  results: (count) => counted(count, "ein Vergleich", "Vergleiche"),
  libraries: (count) => counted(count, "eine Bibliothek von Primitiven", "Bibliotheken"),
  listed: (words) =>
    words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} und ${words.at(-1)}`,
  when: (at) => new Intl.DateTimeFormat("de", { dateStyle: "long", timeStyle: "short" }).format(at),
  offer: (when, contents) =>
    `Von ${when === null ? "einem früheren Besuch" : `deinem Besuch am ${when}`}: ${contents}.`,
  notWhole: "Der Rest davon ist nicht lesbar.",
  taken: "Ein anderer Tab hat es.",
  bringBack: "Zurückholen",
  forgetVisit: "Vergessen",
  earlier: (count) => `Frühere Besuche: noch ${count}`,
  unreadable: (count) =>
    `${count === 1 ? "Ein früherer Besuch ist" : `${count} frühere Besuche sind`} nicht lesbar: beschädigt, oder von einer anderen Version dieser Seite.`,
  forget: "Alles vergessen",
  forgetTitle: "Alles vergessen?",
  undoable:
    "Du kannst das rückgängig machen, bis du die Seite verlässt oder neu lädst. Andere offene Tabs, eine Versuchsperson, die gerade antwortet, und die Dateien auf deinem Gerät bleiben, wie sie sind.",
  undo: "Rückgängig",
  notForgotten: "Nicht alles wurde vergessen",
  notBack: "Nicht alles kam zurück",
  ofVisits: (contents, earlier) =>
    earlier === 0
      ? contents
      : `${contents} (aus diesem Besuch und ${counted(earlier, "einem früheren", "früheren")})`,
  allAnswers: "alle Antworten von Versuchspersonen auf diesem Gerät",
  answers: (answers, participants) =>
    `${counted(answers, "die Antwort", "Antworten")} von ${counted(participants, "einer Versuchsperson", "Versuchspersonen")} auf diesem Gerät`,
  storesNothing:
    "Dieser Browser speichert noch nichts von deinen Besuchen. Danach speichert er auch von diesem Besuch nichts.",
  removes: (pieces) =>
    `Damit verschwinden aus diesem Browser: ${pieces.join(", und ")}. Danach speichert er auch von diesem Besuch nichts.`,
  forgotten: (pieces) =>
    `Vergessen${pieces.length === 0 ? "" : `: ${pieces.join(", und ")}`}. Es kommt nur mit „Rückgängig“ zurück, und nur bis du die Seite verlässt.`,
  notKept: "Dieser Besuch kann nicht behalten werden",
  notKeptWhy: (why) =>
    `Der Browser speichert ihn nicht: ${why}. Speichere, was du nach dem Schließen oder Neuladen der Seite haben willst.`,
  full: "sein Speicher für diese Seite ist voll",
  notBroughtBack: "Der frühere Besuch konnte nicht zurückgeholt werden",
  otherTab: "Ein anderer Tab hat ihn zurückgeholt oder entfernt.",
  notAllBroughtBack: "Nicht alles vom früheren Besuch kam zurück",
  trainingRuns: "Ein Training läuft: Brich es zuerst ab, oder hole den Besuch zurück, wenn es zu Ende ist.",
  keepsPresent: "Du behältst die Arbeit auf dieser Seite.",
  theClip: (title) => `Der Clip ${title}`,
  theTrainings: "Die Trainings",
  theModel: "Das Modell",
  theLibrary: "Die Bibliothek von Primitiven",
};
