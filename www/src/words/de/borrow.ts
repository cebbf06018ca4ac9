import { decimal } from "../decimal";
import type { Words } from "../en";

const metres = (value: number) => decimal("de", value, 2);
const centimetres = (value: number) => decimal("de", Math.abs(100 * value), 0);
const height = (value: number) => `${centimetres(value)} cm ${value < 0 ? "unter" : "über"} der Hüfte`;

export const borrow: Words["chapters"]["borrow"] = {
  title: "Geliehene Arme",
  text:
    "Eine Bibliothek bewahrt, was jeder Körperteil gelernt hat: Beine, die gehen, Arme, die schwingen, " +
    "Arme, die winken. So ein Stück ist ein Bewegungsprimitiv. Die Stücke wurden einmal gelernt und lassen " +
    "sich neu zusammensetzen. Du siehst eine Bewegung, die als Ganzes gelernt wurde, aus Clips von einem " +
    "Programm. Gleich bekommen diese Beine die Arme einer anderen, die sie nie getroffen haben.",
  guess: {
    question: "Was werden die geliehenen Arme tun?",
    choices: { own: "Ihre eigene Bewegung", legs: "Weiter schwingen", still: "Sich kaum bewegen" },
  },
  opening: "Die Bibliothek wird geöffnet.",
  measuring: "Die neue Bewegung wird vermessen.",
  movements: { walk: "Gehen", wave: "Winken", run: "Laufen", jump: "Springen" },
  parts: { legs: "Beine", arms: "Arme" },
  never: "Das zeigt kein Clip.",
  recorded: (movement) => `Als Ganzes gelernt: ${movement}.`,
  hands: (is, speed) => `Die Hände sind im Mittel ${height(is)} und bewegen sich mit ${metres(speed)} m/s.`,
  compared: (movement, is, speed) =>
    `Mit den eigenen Beinen, beim ${movement}: ${height(is)}, ${metres(speed)} m/s.`,
  feet: (steps) => `Die Füße machen ${decimal("de", steps, 1)} Schritte in der Sekunde.`,
  outcome: {
    own: "Die Arme machen ihre eigene Bewegung.",
    legs: "Die Arme schwingen wie zuvor.",
    still: "Die Arme bewegen sich kaum.",
  },
  figure: "Eine Figur, die sich ohne Ende bewegt. Ziehen dreht die Ansicht; Tasten: w, a, s, d.",
};
