import { withComma } from "../decimal";
import type { Words } from "../en";

export const product: Words["chapters"]["product"] = {
  title: "Zwei Vermutungen, ein Schritt",
  text:
    "Zwei Experten vermuten den nächsten Schritt der Arme: die Arme und die Beine. Eine Vermutung ist eine Glocke: " +
    "eine Mitte und ein Kreis, dessen Größe ihre Varianz ist, Alpha. Beide Glocken werden multipliziert: Der Schritt " +
    "liegt dazwischen, näher beim kleineren Kreis. Die der Beine liegt weit daneben: Sie haben als Team gelernt. " +
    "Zieh an einem Kreis.",
  guess: {
    question: "Wir verdoppeln beide Alphas. Wie bewegen sich die Arme?",
    choices: {
      more: "Sie holen weiter aus",
      same: "Genau wie vorher",
      less: "Sie holen weniger weit aus",
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
  hint: "Zieh an den Punkten neben den Kreisen.",
  learned: "Wie gelernt",
  twice: "Beide verdoppeln",
  doubled: (millimetres: string, wider: string) =>
    `In zehn Sekunden ist kein Gelenk weiter als ${withComma(millimetres)} mm von seinem alten Weg. Nur der Kreis des Schritts ist ` +
    `${withComma(wider)}-mal so weit: Das Verhältnis der Alphas sagt, wohin, ihre Größe, wie genau.`,
  equation: "Die Gewichte w hängen nur vom Verhältnis der Alphas ab. Die Varianz des Produkts nicht.",
};
