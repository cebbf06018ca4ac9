// The German words of the page.
import { arms } from "./de/arms";
import { belief } from "./de/belief";
import { borrow } from "./de/borrow";
import { push } from "./de/push";
import type { Words } from "./en";
import { withComma } from "../ui/decimal";

const frame: Words["frame"] = {
  page: "Gekoppelte Bewegungs\u00adprimitive",
  story: "Geschichte",
  lab: "Labor",
  teach: "Lehre",
  views: "Ansichten",
  stage: "Bühne",
  chapters: "Kapitel",
  place: (chapter, count) => `${chapter} von ${count}`,
  back: "Voriges Kapitel",
  next: "Weiter",
  nextChapter: "Weiter zum nächsten Kapitel",
  guessed: (choice) => `Deine Vermutung: ${choice}`,
  hands: (count, total, choice) => `${count} von ${total} sagten „${choice}“`,
  equation: "Die Gleichung",
  openInLab: "Im Labor öffnen",
  loading: "Wird geladen",
  notLoaded: "Dieser Teil der Seite konnte nicht geladen werden. Ist dieses Gerät offline?",
  labNotLoaded: "Das Labor konnte nicht geladen werden. Ist dieses Gerät offline?",
  tryAgain: "Noch einmal versuchen",
  noModel: (why) => `Das Modell läuft hier nicht: ${why}`,
  dismiss: "Schließen",
};

const hand: Words["chapters"]["hand"] = {
  title: "Zeichne. Es geht weiter.",
  text:
    "Ein Bewegungsprimitiv ist ein kleines Modell einer Bewegung. Mach eines: Zeichne in das Feld. Das Modell lernt " +
    "hier, in deinem Browser, wie dein Stift von Moment zu Moment weitergeht. Dann zeichnet es selbst.",
  example: "Zeig es mir",
  two: "Mit zwei Händen zeichnen",
  again: "Leeren",
  learned: (points) =>
    `Daneben steht, was sich das Modell merkt: zwei Zahlen für jeden Moment, auf einer Schleife. ${points} markierte Punkte halten seine Regel für den nächsten Schritt.`,
};

const end: Words["chapters"]["end"] = {
  title: "Jetzt gehört es dir",
  text:
    "Das weißt du nun: Jeder Teil eines Körpers kann eine eigene kleine Regel haben, die um eine Schleife führt. Die " +
    "Regel sagt, wo sie nicht sicher ist. Die Regeln zweier Teile werden multipliziert, und Alpha sagt, wer zählt. So " +
    "kann man Teile trennen, anstoßen und austauschen.",
};

const gaussian: Words["chapters"]["gaussian"] = {
  title: "Was ist ein Gaußprozess?",
  text:
    "Ein Gaußprozess errät eine Kurve aus Punkten. In der Nähe eines Punktes ist er sicher; weit weg von allen " +
    "Punkten ist er es nicht und sagt das auch: Das Band reicht zwei Standardabweichungen weit. Zieh die Punkte " +
    "und sieh der Kurve zu. Wenige Stützpunkte können für alle stehen, und auch wo man fragt, darf unsicher sein.",
  guess: {
    question: "Was sagt er an der gepunkteten Linie, weit weg von allen Punkten?",
    choices: {
      on: "Die Kurve geht weiter wie bisher",
      prior: "Null, mit einem breiten Band",
      nothing: "Nichts",
    },
  },
  plane: "Ein Gaußprozess mit einem Eingang",
  point: (number: number) => `Punkt ${number}: Pfeiltasten bewegen ihn`,
  inducing: (number: number) => `Stützpunkt ${number}: Pfeiltasten bewegen ihn`,
  input: "Der Eingang: Pfeiltasten bewegen ihn",
  hint: "Zieh die Punkte.",
  exact: "Alle Punkte",
  sparse: (count: number) => `${count} Stützpunkte`,
  spread: "Unsicherer Eingang",
  reveal: {
    answer: (mean: string, deviation: string, near: string) =>
      `Dort: ${withComma(mean)} ± ${withComma(deviation)} (2 σ), wie vor dem ersten Punkt. Am ersten Punkt: ± ${withComma(near)}.`,
    input: (mean: string, deviation: string) =>
      `Am orangen Eingang: ${withComma(mean)} ± ${withComma(deviation)}.`,
  },
  equation: "Der Kern k sagt, wie ähnlich sich die Kurve an zwei Eingängen ist.",
};

const loop: Words["chapters"]["loop"] = {
  title: "Ein Gang ist eine Schleife",
  text:
    "Eine Pose der Beine ist eine lange Liste von Winkeln. Beim Gehen bewegen sich die Winkel gemeinsam: Das " +
    "Modell schreibt eine Pose als drei Zahlen, als Punkt in einem kleinen Raum. Der Punkt läuft auf einer " +
    "Schleife, einmal herum für je zwei Schritte. Zieh ihn entlang, und der Körper folgt. Um die Schleife " +
    "herum liegen Punkte, die das Modell nie gesehen hat.",
  guess: {
    question: "Wir ziehen den Punkt von der Schleife weg. Was tut der Körper?",
    choices: {
      walk: "Er macht andere Schritte",
      stop: "Er bleibt in der letzten Pose",
      dissolve: "Er verblasst: Das Modell wird unsicher",
    },
  },
  dot: "Der Punkt auf der Schleife der Beine: Pfeiltasten links und rechts bewegen ihn herum, oben und unten von der Schleife weg",
  plane: "Der latente Raum der Beine",
  sizes: (columns: number, latent: number) => `Beine: aus ${columns} Zahlen werden ${latent}`,
  hint: "Zieh den Punkt die Schleife entlang.",
  hintOff: "Zieh den Punkt jetzt irgendwohin. Farbe: wo das Modell die Pose kennt.",
  walk: "Lass ihn gehen",
  offLoop: (here: string, loop: string) =>
    `Hier ist der Zweifel des Modells an der Pose ${withComma(here)} % des Zweifels weit weg von allen Daten; auf der Schleife sind es ` +
    `höchstens ${withComma(loop)} %. Die Beine sind so blass gezeichnet, wie das Modell unsicher ist.`,
  onLoop: (loop: string) =>
    `Auf der Schleife ist der Zweifel des Modells an der Pose höchstens ${withComma(loop)} % des Zweifels weit weg von allen Daten.`,
  equation:
    "Die Posenabbildung g macht aus einem Punkt x eine Pose y. Ihr Zweifel ist die Standardabweichung von g bei x.",
};

const next: Words["chapters"]["next"] = {
  title: "Wie geht es weiter?",
  text:
    "Das Modell hat eine Regel für den nächsten Schritt gelernt: einen Gaußprozess, wie auf der Karte davor. " +
    "Die Regel kennt, wo der Punkt war und wo er ist, und sagt, wo er sein wird: Der Pfeil ist ihre Vermutung, der Kreis zeigt, wie sicher " +
    "sie ist. Vermutung für Vermutung entsteht ein Weg. Wo ist der Punkt in zehn Bildern? Steck eine Nadel dorthin und sieh dir dann Zukünfte an, die das " +
    "Modell für möglich hält.",
  guess: {
    question: "Wo ist der Punkt in einer Drittelsekunde? Beweg die Nadel.",
    choices: { pin: "Meine Nadel steckt" },
  },
  pin: "Die Nadel: Pfeiltasten bewegen sie",
  anywhere: "Ein beliebiger Anfang: Pfeiltasten bewegen ihn",
  plane: "Der latente Raum der Beine, mit dem nächsten Schritt",
  hint: "Der Kreis reicht zwei Standardabweichungen weit.",
  hintAnywhere: "Drück jetzt irgendwohin: Dort beginnt der Gang, und der Weg biegt in die Schleife ein.",
  again: "Ein anderer Anfang",
  away: (deviations: string) =>
    `Deine Nadel ist ${withComma(deviations)} Standardabweichungen vom Mittel der Zukünfte entfernt.`,
  beat: (beaten: number, futures: number) =>
    beaten === 0
      ? `Alle ${futures} Zukünfte, die das Modell gezogen hat, sind näher: weit daneben.`
      : `Sie ist näher als ${beaten} von ${futures} Zukünften, die das Modell gezogen hat.`,
  back: (seconds: string) => `Von dort war der Weg nach ${withComma(seconds)} s wieder auf der Schleife.`,
  lost: "Von dort kam der Weg in vier Sekunden nicht zur Schleife zurück.",
  equation: "Der nächste Punkt eines Teils liegt um die Vermutung der Experten f, mit der Varianz α.",
};

const points: Words["chapters"]["points"] = {
  title: "Wenige Posen genügen",
  text:
    "Das Modell behält die Aufnahmen nicht. Es behält wenige Posen und wenige Schritte, die Stützpunkte. Was es " +
    "gelernt hat, ist glatt; so kann es alles zwischen diesen Punkten berechnen. Hier sind die der Beine. Was geschieht, wenn wir welche wegnehmen? Für " +
    "jede Wahl löst die Seite das Modell mit denselben Daten neu und misst den Gang.",
  guess: {
    question: (poses: number, steps: number) =>
      `Die Beine haben ${poses} Posen und ${steps} Schritte. Wie viele der ${poses + steps} braucht der Gang?`,
    choices: { most: "Fast alle", half: "Etwa die Hälfte", few: "Zehn oder weniger" },
  },
  plane: "Der latente Raum der Beine mit ihren Stützpunkten",
  legend: "◆ Posen   ➝ Schritte",
  point: {
    poses: (number: number) => `Pose ${number}`,
    steps: (number: number) => `Schritt ${number}`,
  },
  found: (count: number, nats: string, centimetres: string) =>
    `${count} Punkte: Gelenke ${withComma(centimetres)} cm daneben, ${nats} Nats weniger Übereinstimmung mit den Aufnahmen.`,
  walks: "Der Gang geht weiter.",
  stumbled: "Der Gang stolpert.",
  enough: (enough: number, all: number, centimetres: string) =>
    `${enough} von ${all} Punkten genügen: Die Gelenke sind im Mittel ${withComma(centimetres)} cm daneben. Die Seite nahm weg, ` +
    "was am wenigsten kostet; noch einer, und der Gang stolpert. Andere Auswahlen brauchen weniger.",
  hint: (fewest: number | null) =>
    fewest === null
      ? "Drück auf Punkte: weg oder zurück. Die wenigsten gewinnen."
      : `Drück auf Punkte: weg oder zurück. Dein Rekord: ${fewest}.`,
  waiting: "Die Seite lädt das Programm, das das Modell neu löst.",
  removing: "Ein Punkt nach dem anderen geht.",
  all: "Alle Punkte",
  pair: (many: number, few: number) => `${many} neben ${few} Punkten`,
  column: (count: number) => `${count} Punkte`,
  chart: {
    bound: "Übereinstimmung (Schranke)",
    error: "Fehler des Gangs",
    guess: "deine Vermutung",
    label: "Schranke und Fehler des Gangs, von allen Punkten links bis zu zweien rechts",
  },
  equation: "Die Verteilung der Stützwerte u, neu gelöst für die Punkte, die übrig sind.",
};

const product: Words["chapters"]["product"] = {
  title: "Zwei Vermutungen, ein Schritt",
  text:
    "Zwei Experten vermuten den nächsten Schritt der Arme: die Arme und die Beine. Eine Vermutung ist eine Glocke: " +
    "eine Mitte und ein Kreis, der mit ihrer Varianz Alpha wächst. Beide Glocken werden multipliziert: Der Schritt " +
    "liegt dazwischen, näher beim kleineren Kreis. Die der Beine allein wäre falsch: Nur das Produkt muss stimmen. " +
    "Zieh an einem Kreis.",
  guess: {
    question: "Wir verdoppeln beide Alphas. Wie bewegen sich die Arme?",
    choices: {
      more: "Sie holen weiter aus",
      same: "Genau wie vorher",
      less: "Sie holen weniger weit aus",
    },
  },
  plane: "Der latente Raum der Arme: zwei Vermutungen und ihr Produkt",
  radius: {
    arms: (alpha: string) => `Kreis der Arme, Alpha ${withComma(alpha)}: Pfeiltasten ändern ihn`,
    legs: (alpha: string) => `Kreis der Beine, Alpha ${withComma(alpha)}: Pfeiltasten ändern ihn`,
  },
  sources: { arms: "Arme", legs: "Beine" },
  row: (name: string, alpha: string, percent: string) =>
    `${name}: Alpha ${withComma(alpha)}, zählt ${percent} %`,
  hint: "Zieh an den Punkten neben den Kreisen.",
  learned: "Wie gelernt",
  twice: "Beide verdoppeln",
  doubled: (millimetres: string, wider: string) =>
    `In zehn Sekunden ist kein Gelenk weiter als ${withComma(millimetres)} mm von seinem alten Weg. Nur der Kreis des Schritts ist ` +
    `${withComma(wider)}-mal so weit: Das Verhältnis der Alphas sagt, wohin, ihre Größe, wie genau.`,
  equation: "Die Gewichte w hängen nur vom Verhältnis der Alphas ab. Die Varianz des Produkts nicht.",
};

export const words: Words = {
  frame,
  /** The chapters of the story, in their order. */
  chapters: { hand, arms, loop, next, points, product, push, borrow, belief, gaussian, end },
};
