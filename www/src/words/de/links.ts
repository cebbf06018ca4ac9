import { decimal } from "../../ui/decimal";
import type { LinkProblem } from "../../links/problem";
import type { LinkWords } from "../en/links";

const number = (value: number) => decimal("de", value, 0);

function problems(problem: LinkProblem): string {
  switch (problem.what) {
    case "version":
      return `Erwartet ist ein gepacktes Modell der Form ${problem.expected}, gefunden „${problem.found}“: Der Link ist von einer anderen Version dieser Seite oder beschädigt.`;
    case "cut":
      return `Erwartet sind ${number(problem.expected)} Zeichen eines gepackten Modells, gefunden ${number(problem.found)}: Der Link wurde unterwegs abgeschnitten oder verändert.`;
    case "character":
      return `Erwartet sind Buchstaben, Ziffern, - und _ im gepackten Modell, gefunden „${problem.found}“ als Zeichen ${number(problem.place)}: Der Link wurde unterwegs verändert.`;
    case "damaged":
      return "Erwartet ist ein gepacktes Modell mit passender Prüfzahl, gefunden eine andere Zahl: Der Link wurde unterwegs verändert.";
    case "long":
      return `Erwartet sind höchstens ${number(problem.most)} Zeichen in einem Link, gefunden ${number(problem.found)}.`;
    case "large":
      return `Erwartet ist ein Modell von höchstens ${number(problem.most)} Byte, gefunden ein größeres.`;
    case "name":
      return `Erwartet ist der Name einer JSON-Datei auf dem Server dieser Seite, gefunden „${problem.found}“.`;
    case "missing":
      return `Erwartet ist die Datei „${problem.file}“ auf dem Server dieser Seite, gefunden ${problem.found === "" ? "keine Antwort" : `die Antwort ${problem.found}`}.`;
    case "browser":
      return "Erwartet ist ein Browser, der Modelle auspacken kann (ab Chrome 80, Firefox 113, Safari 16.4), gefunden ein anderer.";
  }
}

export const words: LinkWords = {
  notOpened: "Das Modell dieses Links wurde nicht geöffnet",
  problems,
  withModel: "Mit dem Modell im Link",
  withModelMeaning: "Öffnet auf jedem Gerät, ohne Datei. Der Link ist lang.",
  making: "Der Link entsteht",
  length: (characters) => `Der Link hat ${number(characters)} Zeichen.`,
  noCode: (most) =>
    `Zu lang für einen QR-Code, der höchstens ${number(most)} Zeichen fasst: Verschicke den Link.`,
  tooLong: (most, found) => `Der Link hätte ${number(found)} Zeichen, mehr als ${number(most)}.`,
  short: {
    title: "Ein kurzer Link, mit QR-Code",
    how: "Speichere das Modell und lege seine Datei auf dem Webspace neben die Seite. Dann öffnet dieser Link sie.",
    file: "Datei",
    save: "Modell speichern",
  },
  frame: "Auf einer eigenen Seite zeigen",
  copyFrame: "Zeile für diese Seite kopieren",
  frameTitle: "Ein Modell von Bewegungen",
};
