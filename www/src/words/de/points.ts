import { withComma } from "../decimal";
import type { Words } from "../en";

export const points: Words["chapters"]["points"] = {
  title: "Wenige Posen genügen",
  text:
    "Das Modell behält die Aufnahmen nicht. Es behält wenige Posen und wenige Schritte, die Stützpunkte. Was es " +
    "gelernt hat, ist glatt; so kann es alles zwischen diesen Punkten berechnen. Hier sind die der Beine. Was geschieht, wenn wir welche wegnehmen? Für " +
    "jede Wahl löst die Seite das Modell mit denselben Daten neu und misst den Gang.",
  guess: {
    question: (poses: number, steps: number) =>
      `Die Beine haben ${poses} Posen und ${steps} Schritte. Wie viele der ${poses + steps} braucht der Gang?`,
    choices: { most: "Fast alle", half: "Etwa die Hälfte", few: "Zehn oder weniger" },
  },
  plane: "Der latente Raum der Beine mit ihren Stützpunkten",
  legend: "◆ Posen   ➝ Schritte",
  point: {
    poses: (number: number) => `Pose ${number}`,
    steps: (number: number) => `Schritt ${number}`,
  },
  found: (count: number, nats: string, centimetres: string) =>
    `${count} Punkte: Gelenke ${withComma(centimetres)} cm daneben, die Schranke ${nats} Nats weniger.`,
  walks: "Der Gang geht weiter.",
  stumbled: "Der Gang stolpert.",
  enough: (enough: number, all: number, centimetres: string) =>
    `${enough} von ${all} Punkten genügen: Die Gelenke sind im Mittel ${withComma(centimetres)} cm daneben. Mit einem weniger ` +
    "stolpert der Gang. Die Seite nahm jedes Mal den Punkt weg, ohne den die Schranke am wenigsten fällt.",
  hint: (fewest: number | null) =>
    fewest === null
      ? "Drück auf Punkte: weg oder zurück. Die wenigsten gewinnen."
      : `Drück auf Punkte: weg oder zurück. Dein Rekord: ${fewest}.`,
  waiting: "Die Seite lädt das Programm, das das Modell neu löst.",
  removing: "Ein Punkt nach dem anderen geht.",
  all: "Alle Punkte",
  pair: (many: number, few: number) => `${many} neben ${few} Punkten`,
  column: (count: number) => `${count} Punkte`,
  chart: {
    bound: "Schranke",
    error: "Fehler des Gangs",
    label: "Schranke und Fehler des Gangs, von allen Punkten links bis zu zweien rechts",
  },
  equation: "Die Verteilung der Stützwerte u, neu gelöst für die Punkte, die übrig sind.",
};
