import type { Replies } from "../en/replies";

export const words: Replies = {
  arms: {
    stop: "Richtig, wenn die Arme behalten, was sie gelernt haben. Drück „Getrennt“ für Arme, deren Regel ohne die Beine neu gelesen wird.",
    step: "Nein: Ohne den Faden sagt den Armen niemand, wann. Sieh auf die Uhr: Ihre Zeiger laufen auseinander.",
    pace: "Richtig.",
  },
  loop: {
    walk: "Nein: Das Modell ist sich der Pose hier weniger sicher. Wohin der nächste Schritt führt, ist eine andere Regel, auf Karte 5.",
    stop: "Nein: Das Modell ist sich der Pose hier weniger sicher. Wohin der nächste Schritt führt, ist eine andere Regel, auf Karte 5.",
    dissolve: "Richtig.",
  },
  gaussian: {
    on: "Nein: So weit weg sagen die Punkte nichts. Gestrichelt: deine Vermutung.",
    prior: "Richtig.",
    nothing: "Fast: Er sagt, wie wenig er weiß.",
  },
  points: {
    most: "Nein: Zwischen zwei Punkten rechnet das Modell.",
    half: "Richtig, auf dem Weg der Seite.",
    few: "Richtig bei guter Wahl: Sechs können gehen. Der Weg der Seite braucht etwa die Hälfte.",
  },
  product: {
    more: "Nein: Beide sind unsicherer, und ihre Anteile bleiben. Der Umriss ist der Gang davor: Er deckt sich.",
    same: "Richtig.",
    less: "Nein: Beide sind unsicherer, und ihre Anteile bleiben. Der Umriss ist der Gang davor: Er deckt sich.",
  },
  push: {
    fall: "Nein: Zum Umfallen braucht man Gewicht.",
    stop: "Nein: Auch von dort führt jede Schätzung weiter.",
    back: "Richtig.",
  },
  borrow: {
    own: "Richtig.",
    legs: "Nein: Diese Arme haben nie von diesen Beinen gelernt.",
    still: "Nein: Sieh auf die Hände.",
  },
  end: {
    unknown:
      "Niemand weiß, wer in einem aufgenommenen Gang wirklich wen treibt. Wann Menschen eine neue Bewegung natürlich nennen, weiß man nur zum Teil. Und nur um einen Gang vorherzusagen, fanden wir dieses Modell, trainiert wie in den Artikeln, nicht besser als zwei viel einfachere, das TMP und das rhythmische DMP.",
    doors: {
      draw: "Deine zwei Hände koppeln",
      lab: "An den Kopplungen ziehen",
      own: "Eine eigene Bewegung lernen",
      primitives: "Bewegungen mischen",
    },
  },
};
