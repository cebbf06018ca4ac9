import type { Words } from "../en";

export const computer: Words["chapters"]["computer"] = {
  title: "Wer von beiden ist gelernt?",
  text:
    "Zwei Gehende, gezeichnet als Lichtpunkte. Den einen bewegt ein Programm nach veröffentlichten " +
    "Kurven des menschlichen Gangs; den anderen ein kleines Modell, das diesem Programm einige Male " +
    "zugesehen hat. Menschen erkennen Bewegung in einer Handvoll Punkten sofort, und auch, was an ihr " +
    "nicht stimmt. Achte auf Knöchel, Hüften und Handgelenke.",
};
