import { decimal } from "../../ui/decimal";
import type { Words } from "../en";

const seconds = (value: number) => `${decimal("de", value, 2)} s`;
const centimetres = (value: number) => `${decimal("de", 100 * value, 0)} cm`;

export const arms: Words["chapters"]["arms"] = {
  title: "Wer sagt den Armen, wann sie schwingen?",
  text:
    "Dieser Gang wurde nie aufgenommen: Ein anderes Modell erzeugt ihn, Schritt für Schritt. Seine Beine und " +
    "seine Arme laufen jeweils auf einer eigenen Schleife. Ein dünner Faden hält sie zusammen: was die " +
    "Beine darüber sagen, wohin die Arme als Nächstes gehen. Niemand hat dem Modell gesagt, dass es ihn " +
    "knüpfen soll; es hat das aus drei aufgenommenen Gängen eines Menschen gelernt. Jetzt schneiden wir den Faden durch.",
  guess: {
    question: "Was werden die Arme tun?",
    choices: { stop: "Anhalten", step: "Im Takt bleiben", pace: "Ein eigenes Tempo finden" },
  },
  parts: ["Beine", "Arme"],
  thread: {
    label: "Der Faden",
    tied: "Verbunden",
    relearned: "Getrennt",
    kept: "Getrennt wie gelernt",
  },
  measuring: "20 Sekunden dieses Gangs werden vermessen.",
  periods: (legs, arms) => `Beine ${seconds(legs)}, Arme ${seconds(arms)} für einen Schwung hin und zurück.`,
  swing: (is, was) => `Die Hände schwingen ${centimetres(is)} statt ${centimetres(was)}.`,
  tied: "Sie bleiben im Takt, weil die Arme auf die Beine hören.",
  outcome: {
    stop: "Die Arme halten an.",
    step: "Die Arme bleiben im Takt.",
    pace: "Die Arme finden ein eigenes Tempo.",
  },
  relearned: "Ihr Experte hat seine drei Gänge noch einmal gelesen, nun ohne die Beine.",
  kept:
    "Wer „anhalten“ gesagt hat, hat auch recht: Hier behalten die Arme, was sie neben den Beinen gelernt " +
    "haben, und allein ist das kein Schwung.",
  equation: (tied, cut) =>
    `α sagt, wie unsicher eine Quelle über einen Teil ist; w ist ihr Anteil am Schritt. Der Anteil der Beine ` +
    `an den Armen: ${decimal("de", 100 * tied, 0)} % verbunden, ${decimal("de", 100 * cut, 0)} % getrennt.`,
  clock: "Phasenuhr: ein Zeiger für die Beine, einer für die Arme. Jeder dreht sich einmal in einem Schwung.",
  figure:
    "Eine gehende Figur. Ziehen dreht den Blick, Scrollen holt sie näher; Tasten: w, a, s, d, plus und minus.",
  walk: "Lass sie gehen",
};
