// The words of what a visitor does live and records, in German.
import { decimal } from "../../ui/decimal";
import type { PerformingWords } from "../en/performing";

export const words: PerformingWords = {
  record: (seconds) => `${seconds} s aufnehmen`,
  recordMeaning: "Nimmt auf, was die Figur tut, während du sie bewegst: Es wird ein Clip",
  left: (seconds) => `Stopp, noch ${seconds} s`,
  making: "Aus der Aufnahme wird ein Clip …",
  title: (number) => `vorgeführt ${number}`,
  live: (model) => `live aus ${model}`,
  note: (model, did) =>
    `Von dir gemacht, live aus dem Modell ${model}${did.length > 0 ? `, mit: ${did.join("; ")}` : ", ohne Änderung"}.`,
  did: {
    feet: "zwei Fingern als Füße",
    wheel: (part) => `dem Rad für ${part}`,
    push: (part) => `Stößen gegen ${part}`,
    record: (part, title) => `einer Aufnahme von ${part} (${title})`,
    cut: (source, target) => `${source} → ${target} getrennt`,
    couplings: "veränderten Kopplungen",
  },
  notRecorded: "Nichts wurde aufgenommen",
  tooShort: "Ein Clip braucht mindestens eine Sekunde Bewegung.",
  play: (title) => `${title} abspielen`,
  train: "Mit meiner Bewegung trainieren",
  trainMeaning: "Trainiert ein Modell mit diesem Clip allein, mit den Einstellungen unter Lernen",
  sound: "Ton",
  soundMeaning: "Ein Klick für jeden Fuß, der aufsetzt, ein Ton für jede Hand, die zeichnet",
  notFilmed: "Kein bewegtes Bild wurde gespeichert",
  film: {
    title: "Bewegtes Bild",
    about: "Ein paar Sekunden der Bühne, zum Zeigen und Schicken",
    left: (seconds) => `Aufnahme läuft, noch ${seconds} s`,
  },
  feet: "Zwei Finger als Füße",
  feetMeaning: "Jeder Druck ist ein Schritt: Die Beine folgen deinem Rhythmus, deinem Hinken, deiner Pause",
  noLegs: "Braucht eine Bewegung, die sich wiederholt, und einen Teil mit der Wurzel und beiden Füßen",
  foot: ["Linker Fuß", "Rechter Fuß"],
  waits: "Einen Moment: Die Füße beginnen nach einem ganzen Doppelschritt.",
  says: {
    step: "Links, rechts, links: Jeder Druck ist ein Schritt. Wo du wartest, wartet der Körper.",
    same: "Derselbe Fuß zweimal ist kein Schritt dieses Zyklus: Dazwischen tritt der andere Fuß auf.",
    fast: "Schneller, als das Modell es kennt: Es geht doppelt so schnell, wie es gelernt hat.",
  },
  handles: {
    caption: "Ein Modell ohne Kopplungen: Zieh an der Figur, oder ändere unten sein Tempo",
    captionMap: "Seine eigenen Kopplungen stehen unten",
    couplings: "Kopplungen des MAP CGPDM",
    kept: "Eine latente Bahn, zusammen mit diesen Kopplungen trainiert; ein vCGPDM lernt eine Verteilung von Bahnen. Je kleiner α, desto mehr bestimmt dieser Teil.",
    title: "Griffe des Bewegungsprimitivs",
    curve:
      "Eine Kurve über der Zeit: Lass ein gezogenes Glied los, und es ist sofort zurück auf seiner Kurve.",
    system: "Ein dynamisches System: Lass ein gezogenes Glied los, und eine Feder zieht es zurück.",
    tempo: (times) => `Tempo ${decimal("de", times, 2)}`,
    drag: "Ziehen bewegt",
    pose: "diese Pose",
    poseMeaning: "Im ersten Bild bewegt Ziehen den Start",
    goal: "das Ziel",
    centre: "die Mitte",
    lift: "Hand heben",
    liftMeaning: "Wie wenn du eine Hand um 30 cm ziehst",
    reset: "Wie gelernt",
  },
};
