import { withComma } from "../decimal";
import type { Words } from "../en";

export const next: Words["chapters"]["next"] = {
  title: "Wie geht es weiter?",
  text:
    "Das Modell hat eine Regel für den nächsten Schritt gelernt: einen Gaußprozess, wie auf der Karte davor. " +
    "Die Regel kennt, wo der Punkt war und wo er ist, und sagt, wo er sein wird: Der Pfeil ist ihre Vermutung, der Kreis zeigt, wie sicher " +
    "sie ist. Vermutung für Vermutung entsteht ein Weg. Wo ist der Punkt in zehn Bildern? Steck eine Nadel dorthin und sieh dir dann Zukünfte an, die das " +
    "Modell für möglich hält.",
  guess: {
    question: "Wo ist der Punkt in einer Drittelsekunde? Beweg die Nadel.",
    choices: { pin: "Meine Nadel steckt" },
  },
  pin: "Die Nadel: Pfeiltasten bewegen sie",
  anywhere: "Ein beliebiger Anfang: Pfeiltasten bewegen ihn",
  plane: "Der latente Raum der Beine, mit dem nächsten Schritt",
  hint: "Der Kreis reicht zwei Standardabweichungen weit.",
  hintAnywhere: "Drück jetzt irgendwohin: Dort beginnt der Gang, und der Weg biegt in die Schleife ein.",
  again: "Ein anderer Anfang",
  away: (deviations: string) =>
    `Deine Nadel ist ${withComma(deviations)} Standardabweichungen vom Mittel der Zukünfte entfernt.`,
  beat: (beaten: number, futures: number) =>
    beaten === 0
      ? `Alle ${futures} Zukünfte, die das Modell gezogen hat, sind näher: weit daneben.`
      : `Sie ist näher als ${beaten} von ${futures} Zukünften, die das Modell gezogen hat.`,
  back: (seconds: string) => `Von dort war der Weg nach ${withComma(seconds)} s wieder auf der Schleife.`,
  lost: "Von dort kam der Weg in vier Sekunden nicht zur Schleife zurück.",
  equation: "Der nächste Punkt eines Teils liegt um die Vermutung der Experten f, mit der Varianz α.",
};
