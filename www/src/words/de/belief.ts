import type { Words } from "../en";

export const belief: Words["chapters"]["belief"] = {
  title: "Wissen wir es, oder glauben wir es?",
  text:
    "Zwei Teile bewegen sich. Treibt einer den anderen, und welcher? Die Wahrheit liegt hinter einem " +
    "Vorhang, denn ein Programm hat diese Bewegungen gemacht und weiß, was es getan hat. Stimme " +
    "zuerst ab. Dann wird hier und jetzt ein Modell mit den Bewegungen trainiert und zeichnet den " +
    "Pfeil, an den es glaubt.",
};
