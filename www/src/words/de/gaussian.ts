import { withComma } from "../decimal";
import type { Words } from "../en";

export const gaussian: Words["chapters"]["gaussian"] = {
  title: "Was ist ein Gaußprozess?",
  text:
    "Ein Gaußprozess errät eine Kurve aus Punkten. In der Nähe eines Punktes ist er sicher; weit weg von allen " +
    "Punkten ist er es nicht und sagt das auch: Das Band reicht zwei Standardabweichungen weit. Zieh die Punkte " +
    "und sieh der Kurve zu. Wenige Stützpunkte können für alle stehen, und auch wo man fragt, darf unsicher sein.",
  guess: {
    question: "Was sagt er an der gepunkteten Linie, weit weg von allen Punkten?",
    choices: {
      on: "Die Kurve geht weiter wie bisher",
      prior: "Null, mit einem breiten Band",
      nothing: "Nichts",
    },
  },
  plane: "Ein Gaußprozess mit einem Eingang",
  point: (number: number) => `Punkt ${number}: Pfeiltasten bewegen ihn`,
  inducing: (number: number) => `Stützpunkt ${number}: Pfeiltasten bewegen ihn`,
  input: "Der Eingang: Pfeiltasten bewegen ihn",
  hint: "Zieh die Punkte.",
  exact: "Alle Punkte",
  sparse: (count: number) => `${count} Stützpunkte`,
  spread: "Unsicherer Eingang",
  reveal: {
    answer: (mean: string, deviation: string, near: string) =>
      `Dort: ${withComma(mean)} ± ${withComma(deviation)} (2 σ), wie vor dem ersten Punkt. Am ersten Punkt: ± ${withComma(near)}.`,
    input: (mean: string, deviation: string) =>
      `Am orangen Eingang: ${withComma(mean)} ± ${withComma(deviation)}.`,
  },
  equation: "Der Kern k sagt, wie ähnlich sich die Kurve an zwei Eingängen ist.",
};
