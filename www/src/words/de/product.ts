import { withComma } from "../decimal";
import type { Words } from "../en";

export const product: Words["chapters"]["product"] = {
  title: "Zwei Vermutungen, ein Schritt",
  text:
    "Zwei Experten sprechen über den nächsten Schritt der Arme: die Arme selbst und die Beine. Jeder gibt eine " +
    "Vermutung ab und sagt mit einem Kreis, wie sicher er ist. Der Schritt, der getan wird, liegt dazwischen, " +
    "näher bei dem, der mehr zählt. Zieh an einem Kreis: Alpha wächst mit seinem Radius, und ein Experte mit " +
    "großem Alpha zählt weniger.",
  guess: {
    question: "Wir verdoppeln beide Alphas. Wie bewegen sich die Arme?",
    choices: {
      more: "Sie schwingen weiter",
      same: "Genau wie vorher",
      less: "Sie schwingen weniger",
    },
  },
  plane: "Der latente Raum der Arme: zwei Vermutungen und ihr Produkt",
  radius: {
    arms: (alpha: string) => `Kreis der Arme, Alpha ${withComma(alpha)}: Pfeiltasten ändern ihn`,
    legs: (alpha: string) => `Kreis der Beine, Alpha ${withComma(alpha)}: Pfeiltasten ändern ihn`,
  },
  sources: { arms: "Arme", legs: "Beine" },
  row: (name: string, alpha: string, percent: string) =>
    `${name}: Alpha ${withComma(alpha)}, zählt ${percent} %`,
  hint: "Zieh an den Punkten auf den Kreisen.",
  learned: "Wie gelernt",
  twice: "Beide verdoppeln",
  doubled: (millimetres: string, wider: string) =>
    `In zehn Sekunden ist kein Gelenk weiter als ${withComma(millimetres)} mm von seinem alten Weg. Nur der Kreis des Schritts ist ` +
    `${withComma(wider)}-mal so weit: Das Verhältnis der Alphas sagt, wohin, ihre Größe, wie genau.`,
  equation: "Die Gewichte w hängen nur vom Verhältnis der Alphas ab. Die Varianz des Produkts nicht.",
};
