import { decimal } from "../../ui/decimal";
import type { Words } from "../en";

const radii = (value: number) => decimal("de", value, value < 1 ? 2 : 1);
const seconds = (value: number) => `${decimal("de", value, 1)} s`;

export const push: Words["chapters"]["push"] = {
  title: "Stoß sie an",
  text:
    "Dieser Gang folgt keiner Aufnahme. Das Modell schätzt jede Pose aus den letzten zwei Posen, " +
    "und seine Schätzungen führen immer wieder um eine Schleife: eine für die Beine, eine für die Arme. " +
    "Jetzt ziehen wir an einer Hand, und die Arme verlassen ihre Schleife. Auch von dort kann das Modell " +
    "die nächste Pose nur aus den letzten zwei schätzen. Dass jemand gezogen hat, weiß es nicht.",
  guess: {
    question: "Was wird der Gang tun?",
    choices: { fall: "Umfallen", stop: "Anhalten", back: "Zurückkommen" },
  },
  parts: ["Beine", "Arme"],
  walk: "Lass sie gehen",
  pull: "Zieh an einer Hand",
  drag: "oder zieh selbst an einer",
  measuring: "Der Heimweg wird gemessen.",
  away: (part, farthest) => `Die ${part} verließen ihre Schleife um ${radii(farthest)} Radien.`,
  home: (time) => `Nach ${seconds(time)} war alles wieder auf seiner Schleife.`,
  lost: "Er ist nicht nach Hause gekommen.",
  back: "Schätzung für Schätzung kam der Weg zur Schleife zurück.",
  wheel: {
    youAre: "Sei die Beine",
    invites: "Sei die Beine: Dreh das Rad. Die Arme folgen.",
    wheel: (part) => `Rad: bewegt die ${part} durch ihren Schritt. Pfeiltasten drehen es, Escape lässt los.`,
    wheelMeaning: "Zieh am Rand: Eine Umdrehung ist ein Schrittzyklus. Lass los, und das Modell geht weiter.",
  },
  noFall: "Umfallen kann er nicht: Er kennt kein Gewicht.",
  equation: (order) => `Der nächste Zustand hängt nur von den letzten ${order} Zuständen ab.`,
  figure:
    "Eine gehende Figur. Hand oder Fuß ziehen; an anderer Stelle dreht Ziehen den Blick; Tasten: w, a, s, d, plus und minus.",
  loops: "Oben die Schleife der Arme, unten die der Beine, jede mit einem Punkt für die Pose jetzt.",
};
