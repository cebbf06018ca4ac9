import type { LoopsWords } from "../en/loops";

export const loops: LoopsWords = {
  title: "[Latente Räume|latent-space]",
  about:
    "Eine Schleife ist der Weg eines [Rollouts|rollout] durch den latenten Raum eines Teils, sein [Bewegungsprimitiv|movement-primitive]. Ein Pfeil ist eine [Kopplung|coupling], so dick wie ihr [Gewicht|w]; ein kleines [α|alpha] ist ein großes Gewicht. Was Kopplungen tun, wird am Körper [gemessen|measured].",
  plot: "Darstellung",
  layers: "In den Bildern zeigen",
  pose: { label: "Posen", meaning: "Stützpunkte der Posen: Posen, an denen die Posenabbildung hängt" },
  dynamics: {
    label: "Dynamik",
    meaning: "Stützpunkte der Dynamik: eine Vorgeschichte und die Vorhersage dazu",
  },
  between: {
    label: "Kopplungen",
    meaning:
      "Stützpunkte der Kopplungen zwischen Teilen: Kreise sind Vorgeschichten, die einen anderen Teil vorhersagen, Dreiecke sind Vorhersagen durch einen anderen Teil",
  },
  aboutPoints: "Was sind Stützpunkte?",
  predictions: {
    label: "Vorhersagen",
    meaning:
      "Was jeder Teil über den nächsten Zustand vorhersagt, eine Standardabweichung breit, in seiner Farbe; schwarz ist das Produkt, zu dem der Schritt führt. Gestrichelt: kaum gehört",
  },
  aboutPredictions: "Was zeigen die Vorhersagen?",
  futures: {
    label: "Zukünfte",
    meaning: "Fünf Bewegungen, die das Modell ebenso machen könnte, zufällig gezogen",
  },
  uncertainty: {
    label: "Unsicherheit",
    meaning: "Wo der Zustand ist, soweit eine Gaußverteilung es sagen kann",
  },
  certainty: {
    label: "wo das Modell sicher ist",
    meaning:
      "Farbe: Posen, bei denen das Modell sicher ist. Pfeile: wohin seine Dynamik führt. In den 2-D-Bildern",
  },
  plotOf: (part) => `Latenter Raum: ${part}`,
  turn: "Ziehen oder Pfeiltasten drehen ihn",
  dynamicsPoint: (number, source, target) =>
    `Stützpunkt ${number} der Dynamik von ${source}${target === null ? "" : ` über ${target}`}`,
  posePoint: (number, part) => `Stützpunkt ${number} der Posen von ${part}`,
  fiveFutures: (first, last) => `[Fünf Zukünfte|future], Startwerte ${first} bis ${last}`,
  fiveOthers: "Fünf andere",
  gaussian: (loading) =>
    `Grau: [was eine Gaußverteilung weiß|moment-matching], ±1 und ±2 σ${loading ? " (wird geladen)" : ""}`,
  push: {
    state: (part) => `Zustand von ${part} jetzt. Ziehen oder Pfeiltasten schieben diesen Teil.`,
    drag: (part) => `Ziehen schiebt ${part}`,
  },
  none: {
    futures: "Keine Zukünfte",
    uncertainty: "Keine Unsicherheit",
    certainty: "Kein Bild davon, wo das Modell sicher ist",
  },
};
