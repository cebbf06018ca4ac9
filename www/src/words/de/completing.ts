// The words of a recording that gives one part, in German.
import type { words as english } from "../en/completing";

export const words: typeof english = {
  about:
    "Eine Aufnahme bewegt einen Teil. Das Modell sieht nur diesen Teil und schließt über die Kopplungen auf die anderen. Der Umriss ist die Aufnahme.",
  given: "Die Aufnahme bewegt",
  recording: "Aufnahme",
  until: "Das Modell sieht sie",
  toTheEnd: "bis zum Ende",
  seconds: (seconds: string) => `${seconds} s lang, dann geht es allein weiter`,
  show: "Zeigen",
  stop: "Zurück zum Modell",
  error: (part: string, ratio: string) => `${part}: Fehler ${ratio}`,
  after: (ratio: string) => `danach ${ratio}`,
  meaning:
    "Der Fehler ist 0, wo sich der Teil wie aufgenommen bewegt, und 1, wo er nicht besser ist als die mittlere Haltung der Clips.",
  ownWalk: "Die Bewegung des Modells, wie gelernt",
  notReady: "Das Modell ist noch nicht bereit. Versuche es gleich noch einmal",
  failed: "Die Aufnahme lässt sich nicht ergänzen",
  caption: (part: string, clip: string) => ({
    title: "Ein Teil aufgenommen, der Rest erschlossen",
    text: `${part}: ${clip}. Umriss: die Aufnahme`,
  }),
};
