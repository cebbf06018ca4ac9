import type { Replies } from "../en/replies";

export const words: Replies = {
  arms: {
    stop: "Richtig für eine andere Frage: Drück „Getrennt wie gelernt“.",
    step: "Nein: Ohne den Faden sagt den Armen niemand, wann.",
    pace: "Richtig.",
  },
  loop: {
    walk: "Nein: Nichts sagt hier, welche Schritte das wären.",
    stop: "Nein: Dazu müsste das Modell hier eine Pose kennen.",
    dissolve: "Richtig.",
  },
  gaussian: {
    on: "Nein: So weit weg sagen die Punkte nichts.",
    prior: "Richtig.",
    nothing: "Fast: Er sagt, wie wenig er weiß.",
  },
  points: {
    most: "Nein: Zwischen zwei Punkten rechnet das Modell.",
    half: "Es geht mit weniger.",
    few: "Richtig.",
  },
  product: {
    more: "Nein: Beide sind unsicherer, und ihre Anteile bleiben.",
    same: "Richtig.",
    less: "Nein: Beide sind unsicherer, und ihre Anteile bleiben.",
  },
  push: {
    fall: "Nein: Zum Umfallen braucht man Gewicht.",
    stop: "Nein: Auch von dort führt jede Schätzung weiter.",
    back: "Richtig.",
  },
  borrow: {
    own: "Richtig.",
    legs: "Nein: Dieser Schwung gehörte den anderen Armen.",
    still: "Nein: Sieh auf die Hände.",
  },
  end: {
    unknown:
      "Das weiß niemand: wer in einem aufgenommenen Gang wirklich wen treibt, und wann Menschen eine neue Bewegung natürlich nennen.",
    doors: {
      draw: "Deine zwei Hände koppeln",
      lab: "An den Kopplungen ziehen",
      own: "Eine eigene Bewegung lernen",
      primitives: "Bewegungen mischen",
    },
  },
};
