import { decimal } from "../decimal";
import type { Words } from "../en";

export const computer: Words["chapters"]["computer"] = {
  title: "Wer hat gehen gelernt?",
  text:
    "Zwei Gänge, nur als Lichtpunkte. Der eine ist ein Programm: Es geht nach Kurven des menschlichen Gangs, die " +
    "Forscher veröffentlicht haben. Der andere ist ein Modell: Es hat drei Gänge dieses Programms gesehen, nicht " +
    "diesen, und macht nun jeden Schritt selbst.",
  guess: { question: "Wer ist das Modell?", choices: { left: "Links", right: "Rechts" } },
  names: { program: "das Programm", model: "das Modell" },
  play: "Lass sie gehen",
  next: "Nächstes Paar",
  again: "Noch einmal",
  right: { left: "Ja, links geht das Modell.", right: "Ja, rechts geht das Modell." },
  wrong: { left: "Nein, das Modell geht links.", right: "Nein, das Modell geht rechts." },
  apart: (metres) =>
    `Pose für Pose sind seine Lichter im Mittel ${decimal("de", 100 * metres, 1)} cm von der nächsten Pose des Programms entfernt.`,
  score: (found, asked) => `Du hast ${found} von ${asked} gefunden. Wer nur rät, findet etwa die Hälfte.`,
};
