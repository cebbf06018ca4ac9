import type { Words } from "../en";

export const loop: Words["chapters"]["loop"] = {
  title: "Ein Gang ist eine Schleife",
  text:
    "Eine Pose dieses Körpers hat 60 Winkel. Das Modell schreibt jede Pose als drei Zahlen, als Punkt " +
    "in einem kleinen Raum. Während der Körper geht, läuft der Punkt auf einer Schleife, einmal herum " +
    "für je zwei Schritte. Zieh den Punkt die Schleife entlang, und der Körper folgt. Zieh ihn dann " +
    "von der Schleife weg, dorthin, wo das Modell nie eine Pose gesehen hat.",
};
