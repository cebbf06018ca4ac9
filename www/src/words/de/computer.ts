import { decimal } from "../decimal";
import type { Words } from "../en";

export const computer: Words["chapters"]["computer"] = {
  title: "Wer von beiden ist ein Computer?",
  text:
    "Ehrlich gesagt: beide. Der eine ist ein Programm, das nach veröffentlichten Kurven des menschlichen " +
    "Gangs geht. Der andere ist ein Modell: Es hat drei Gänge dieses Programms gesehen, aber nicht " +
    "diesen, und geht nun selbst. Zu sehen sind nur Lichtpunkte.",
  guess: { question: "Wer ist das Modell?", choices: { left: "Links", right: "Rechts" } },
  names: { program: "das Programm", model: "das Modell" },
  play: "Lass sie gehen",
  next: "Nächstes Paar",
  again: "Noch einmal",
  right: { left: "Ja, links geht das Modell.", right: "Ja, rechts geht das Modell." },
  wrong: { left: "Nein, das Modell geht links.", right: "Nein, das Modell geht rechts." },
  apart: (metres) =>
    `Seine Lichter sind im Mittel ${decimal("de", 100 * metres, 1)} cm von denen des Programms entfernt.`,
  score: (found, asked) => `Du hast ${found} von ${asked} gefunden. Wer nur rät, findet etwa die Hälfte.`,
};
