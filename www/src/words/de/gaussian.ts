import type { Words } from "../en";

export const gaussian: Words["chapters"]["gaussian"] = {
  title: "Was ist ein Gaußprozess?",
  text:
    "Ein Gaußprozess errät eine Kurve aus Punkten. In der Nähe eines Punktes ist er sicher; weit weg " +
    "von allen Punkten ist er es nicht und sagt das auch: Das Band zeigt, wie sicher. Zieh die Punkte " +
    "und sieh der Kurve zu. Wenige Stützpunkte können für alle stehen.",
};
