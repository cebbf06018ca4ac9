import { decimal } from "../../ui/decimal";
import type { Words } from "../en";
import type { Ratio } from "../en/belief";

const ratio = (numbers: Ratio) => {
  const [mean, low, high] = numbers.map((value) => decimal("de", value, 2));
  return `${mean}-mal so groß (${low} bis ${high})`;
};
const times = (value: number) => decimal("de", value, value < 10 ? 1 : 0);

export const belief: Words["chapters"]["belief"] = {
  title: "Wissen wir es, oder glauben wir es?",
  text:
    "Zwei Punkte bewegen sich. Treibt einer den anderen, und welcher? Die Wahrheit liegt hinter einem " +
    "Vorhang, denn ein Programm hat diese Bewegungen gemacht und weiß, was es getan hat. Bei einem " +
    "aufgenommenen Gang kennt niemand die Wahrheit: Ein Modell kann nur sagen, was die Aufnahme erklärt. " +
    "Stimme zuerst ab. Dann lernt ein Modell hier und jetzt aus zehn verrauschten Kurven jedes Punktes und zeichnet " +
    "den Pfeil, an den es glaubt.",
  guess: {
    question: "Wer treibt wen?",
    choices: { ab: "A treibt B", ba: "B treibt A", none: "Keiner" },
  },
  drawing: "Die Bewegungen werden gemacht.",
  training: (share) => `Das Modell lernt: ${decimal("de", 100 * share, 0)} %.`,
  failed: (why) => `Das Modell konnte nicht lernen: ${why}`,
  believes: {
    ab: "Das Modell glaubt, dass A treibt.",
    ba: "Das Modell glaubt, dass B treibt.",
    none: "Das Modell glaubt, dass keiner den anderen treibt.",
    both: "Das Modell glaubt, dass jeder den anderen treibt.",
  },
  measured: (ab, ba, limit) =>
    `Sein α von A nach B ist ${times(ab)}-mal so groß wie das von B selbst, von B nach A ${times(ba)}-mal ` +
    `so groß wie das von A selbst. Ab ${decimal("de", limit, 0)}-mal zählt es als kein Einfluss.`,
  curtain: "Zeig die Wahrheit",
  truth: {
    ab: "Die Wahrheit: Ein Zehntel jeder Bewegung von B kommt von A.",
    ba: "Die Wahrheit: Ein Zehntel jeder Bewegung von A kommt von B.",
    none: "Die Wahrheit: Sie haben nichts miteinander zu tun.",
  },
  score: (you, model, rounds) =>
    `Bisher richtig: du ${you} von ${rounds}, das Modell ${model} von ${rounds}.`,
  closing: (uncoupled, dmp) =>
    `Bei neuen aufgenommenen Gängen ist der Fehler eines Modells mit Kopplungen, trainiert wie in den Artikeln, ${ratio(uncoupled)} wie der eines ` +
    `Modells ohne und ${ratio(dmp)} wie der einer rhythmischen DMP, im Mittel über zehn Personen: beides ` +
    "unentschieden.",
  again: "Ein anderes Paar",
  modelRow: "das Modell glaubt",
  truthRow: "die Wahrheit",
  figure: "Zwei Punkte, A links und B rechts, jeder auf seiner eigenen Bahn.",
};
