import { withComma } from "../decimal";
import type { Words } from "../en";

export const loop: Words["chapters"]["loop"] = {
  title: "Ein Gang ist eine Schleife",
  text:
    "Eine Pose der Beine ist eine lange Liste von Winkeln. Beim Gehen bewegen sich die Winkel gemeinsam: Das " +
    "Modell schreibt eine Pose als drei Zahlen, als Punkt in einem kleinen Raum. Der Punkt läuft auf einer " +
    "Schleife, einmal herum für je zwei Schritte. Zieh ihn entlang, und der Körper folgt. Um die Schleife " +
    "herum liegen Punkte, die das Modell nie gesehen hat.",
  guess: {
    question: "Wir ziehen den Punkt von der Schleife weg. Was tut der Körper?",
    choices: {
      walk: "Er macht andere Schritte",
      stop: "Er bleibt in der letzten Pose",
      dissolve: "Das weiß niemand, auch das Modell nicht",
    },
  },
  dot: "Der Punkt auf der Schleife der Beine: Pfeiltasten links und rechts bewegen ihn herum, oben und unten von der Schleife weg",
  plane: "Der latente Raum der Beine",
  sizes: (columns: number, latent: number) => `Beine: aus ${columns} Zahlen werden ${latent}`,
  hint: "Zieh den Punkt die Schleife entlang.",
  hintOff: "Zieh den Punkt jetzt irgendwohin. Farbe: wo das Modell die Pose kennt.",
  walk: "Lass ihn gehen",
  offLoop: (here: string, loop: string) =>
    `Hier ist der Zweifel des Modells an der Pose ${withComma(here)} % des Zweifels vor dem Training; auf der Schleife sind es ` +
    `höchstens ${withComma(loop)} %. Die Beine sind so blass gezeichnet, wie das Modell unsicher ist.`,
  onLoop: (loop: string) =>
    `Auf der Schleife ist der Zweifel des Modells an der Pose höchstens ${withComma(loop)} % des Zweifels vor dem Training.`,
  equation:
    "Die Posenabbildung g macht aus einem Punkt x eine Pose y. Ihr Zweifel ist die Standardabweichung von g bei x.",
};
