import { decimal } from "../../ui/decimal";
import type { Words } from "../en";

const metres = (value: number) => decimal("de", value, 2);
const centimetres = (value: number) => decimal("de", Math.abs(100 * value), 0);
const height = (value: number) => `${centimetres(value)} cm ${value < 0 ? "unter" : "über"} der Hüfte`;

export const borrow: Words["chapters"]["borrow"] = {
  title: "Geliehene Arme",
  text:
    "Eine Bibliothek bewahrt, was jeder Körperteil gelernt hat: Beine, die gehen oder laufen, Arme eines " +
    "Hampelmanns, ein Arm, der winkt. So ein Stück ist ein Bewegungsprimitiv. Die Stücke wurden einmal aus " +
    "Aufnahmen gelernt und lassen sich neu zusammensetzen. Du siehst einen Gang, der als Ganzes gelernt wurde. " +
    "Gleich bekommen seine Beine die Arme eines Hampelmanns. Das hat nie jemand aufgenommen.",
  guess: {
    question: "Was werden die geliehenen Arme tun?",
    choices: { own: "Ihre eigene Bewegung", legs: "Weiter schwingen", still: "Sich kaum bewegen" },
  },
  opening: "Die Bibliothek wird geöffnet.",
  measuring: "Die neue Bewegung wird vermessen.",
  movements: { walk: "Gehen", run: "Laufen", jump: "Hampelmann", wave: "Winken" },
  parts: { legs: "Beine", arms: "Arme" },
  never: "Nie aufgenommen.",
  recorded: (movement) => `Als Ganzes gelernt: ${movement}.`,
  hands: (is, speed) => `Hände im Mittel: ${height(is)}, ${metres(speed)} m/s`,
  compared: (is, speed) => `; mit den eigenen Beinen: ${height(is)}, ${metres(speed)} m/s`,
  feet: (steps) =>
    steps > 0 ? `${decimal("de", steps, 1)} Schritte in der Sekunde.` : "Der Körper bleibt auf seinem Platz.",
  outcome: {
    own: "Die Arme machen ihre eigene Bewegung.",
    legs: "Die Arme schwingen wie zuvor.",
    still: "Die Arme bewegen sich kaum.",
  },
  wheel: (part) => `Rad: bewegt die ${part} durch ihren Schritt. Pfeiltasten drehen es, Escape lässt los.`,
  wheelMeaning: "Zieh am Rand: Eine Umdrehung ist ein Schrittzyklus. Lass los, und das Modell geht weiter.",
  figure:
    "Eine Figur, die sich ohne Ende bewegt. Zieh an einer Hand oder einem Fuß, sonst dreht Ziehen die Ansicht; Tasten: w, a, s, d.",
};
