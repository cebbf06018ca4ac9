import type { Words } from "../en";

export const points: Words["chapters"]["points"] = {
  title: "Zehn Posen genügen",
  text:
    "Das Modell behält die Aufnahmen nicht. Es behält wenige Posen und wenige Schritte, die " +
    "Stützpunkte, und berechnet alles andere aus ihnen. Setze welche oder nimm welche weg, bis der " +
    "Gang stolpert. Wer die wenigsten braucht, gewinnt. Die Schranke sagt, wie viel verloren geht; " +
    "sie wird für jede deiner Wahlen neu berechnet.",
};
