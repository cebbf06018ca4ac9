import { withComma } from "../ui/decimal";
import type { ExperimentWords } from "./en";

const number = (value: number) => withComma(String(value));

export const words: ExperimentWords = {
  title: "Wer treibt wen?",
  setup: "Das Experiment",
  part: (place) => `Teil ${place}`,
  train: "Trainieren",
  training: "Training",
  cancel: "Abbrechen",
  cancelMeaning: "Endet hier und behält das Beste bis jetzt",
  trained: "Dieser Startwert ist fertig trainiert; er fände wieder dasselbe",
  stopping: "Wird beendet",
  settingUp: "Wird vorbereitet",
  iteration: (iteration) => `Iteration ${iteration}`,
  seedsDone: (over, all) => `${over} von ${all} Startwerten fertig`,
  failed: (why) => `Das Training ist gescheitert: ${why}`,
  seedDecides: "Der Startwert bestimmt die Daten und das Training.",
  share: (per100) => `Training, ${per100} Prozent fertig`,
  ended: "Das Training ist zu Ende.",
  seed: "Startwert",
  driving: "Teil 1 treibt Teil 2",
  drivingHint: "Ohne Häkchen zur Kontrolle: zwei Systeme, die nichts miteinander zu tun haben.",
  points: "Stützpunkte",
  pointsHint: "Jeder Funktion. Vier: das andere Modell aus Abbildung 3 des Artikels.",
  ten: (driving) => `Startwerte 0 bis 9 ${driving ? "" : "ohne Einfluss "}trainieren`,
  source:
    "Das Experiment ist das von Velychko et al. (2018), Abschnitt 5.1. Ihre Zufallszüge sind nicht bekannt; diese sind unsere.",
  notMade: (why) => `Das Experiment konnte nicht gemacht werden: ${why}`,
  tryAgain: "Noch einmal",
  riddle: {
    give: "Gib mir ein Rätsel",
    giveMeaning: "Ein Experiment, dessen Wahrheit hinter einem Vorhang bleibt",
    question: "Treibt Teil 1 Teil 2? Sieh dir die Kurven beider an, und stimme ab. Dann lernt ein Modell.",
    yes: "Ja",
    no: "Nein",
    voted: (yes) => `Du sagst ${yes ? "ja" : "nein"}.`,
    read: "Was liest du aus den α in Schritt 3?",
    curtain: "Zeig die Wahrheit",
    none: "Kein Rätsel: einen Startwert wählen",
    truth: (driving, right) =>
      `Die Wahrheit: ${driving ? "Teil 1 treibt Teil 2." : "Keiner treibt den anderen."} Du hattest ${right ? "recht" : "nicht recht"}.`,
  },
  made: {
    title: "Was gemacht wurde",
    hidden:
      "Zwei Systeme, jedes ein Punkt, der sich in der Ebene bewegt. Ob Teil 1 Teil 2 treibt, liegt hinter einem Vorhang, und die Punkte auch: Ihre Wege würden es verraten.",
    points: (frames) => `Zwei Systeme, jedes ein Punkt, der sich ${frames} Bilder lang in der Ebene bewegt.`,
    driven:
      "Teil 1 folgt einer eigenen Regel. Auch Teil 2 folgt einer eigenen Regel, aber ein Zehntel jedes Schritts kommt von Teil 1.",
    control: "Jedes folgt einer eigenen Regel. Dies ist die Kontrolle: Teil 1 hat keinen Anteil an Teil 2.",
    rules:
      "Die Regeln sind zufällig gezogen, und zwar so, dass die Punkte im Kreis gehen, jeder in seinem Tempo.",
  },
  seen: {
    title: "Was das Modell sieht",
    text: (frames) =>
      `Nicht die Punkte: nur zehn verrauschte Kurven jedes Teils. Auch die Funktionen, die sie aus dem Punkt machen, sind zufällig gezogen. Niemand sagt dem Modell, wer wen treibt. Die ersten ${frames} Bilder:`,
  },
  found: {
    title: "Was das Training findet",
    colours:
      "Grau: die wahren Punkte. In Farbe: die gelernten. Ein Modell findet seine latenten Zustände nur bis auf Streckung, Drehung und Verschiebung; darum werden sie mit kleinsten Quadraten über die wahren gelegt.",
    alpha:
      "Ein kleines α ist ein großer Einfluss; die Gewichte w, die zu einem Teil führen, ergeben zusammen 1. Sie sind nicht unbedingt die 0,1 und 0,9 aus Schritt 1: Eine größere Funktion gleicht ein kleineres Gewicht aus.",
    largest: (alpha) => `Kein α kann größer sein als ${number(alpha)}.`,
    noise: (mse) => `Das Rauschen allein ergibt einen MSE von ${number(mse)}.`,
  },
  inside: {
    title: "Im Inneren des Modells",
    text: (points) =>
      `Jede Funktion behält ${points} Stützpunkte statt aller Bilder. Vor dem Training sind die latenten Zustände eine erste Schätzung, die zwei größten Hauptkomponenten der geglätteten Kurven, und die Punkte liegen auf ihnen. Das Training bewegt beide.`,
    before: "vor dem Training",
    after: "nach dem Training",
    press: "Drücke Trainieren.",
    learned: "gelernte latente Zustände",
    path: "mittlerer Weg: das Modell macht von seinen ersten zwei Zuständen allein weiter",
    dynamics: "Stützpunkt der Dynamik: zwei Zustände, der spätere ausgefüllt",
    poses: "Stützpunkt der Posenabbildung",
    curves:
      "Untere Reihe: drei der zehn Kurven der Daten in Grau, und die des mittleren Weges in Farbe. Wie in Abbildung 3, E bis H, des Artikels.",
    control:
      "Trainiere auch mit vier Stützpunkten: Dann geht der mittlere Weg vor dem Training meist nicht so im Kreis wie die Daten, aber danach. Mit zehn tut er es meist von Anfang an, und die Kurven passen besser.",
    plane: (part, when) =>
      `Teil ${part}, ${when}: Stützpunkte, latente Zustände und mittlerer Weg in der Ebene, darunter drei Kurven über der Zeit`,
    save: "Modell speichern",
    open: "In Zeitreihen öffnen",
    file: "Ein Modell einer Tabelle mit 20 Spalten: Rollouts, Kopplungen und das Programm für das Terminal nehmen es wie jedes andere.",
  },
  others: {
    title: "Probiere es aus",
    text: "Ein Startwert beweist wenig. Probiere andere, und nimm das Häkchen weg: Dann muss α von 1 nach 2 groß werden. Das gelingt nicht immer: docs/synthetic.md im Projekt sagt, wie oft.",
    means: (much, alike) =>
      `Gefunden heißt: α von 2 nach 1 ist mindestens ${number(much)}-mal so groß wie α von 1 nach 1, und α von 1 nach 2 unterscheidet sich von α von 2 nach 2 höchstens um den Faktor ${number(alike)}; ohne Einfluss ist es mindestens ${number(much)}-mal so groß.`,
  },
  pictures: {
    true: (part) => `Teil ${part}: die wahren latenten Zustände, ein Weg in der Ebene`,
    learned: (part, explained) =>
      `Teil ${part}: die gelernten latenten Zustände über den wahren, von denen sie ${explained} erklären`,
    explained: (share) => `${share} erklärt`,
    curves: (part) => `Teil ${part}: zehn verrauschte Kurven über der Zeit`,
  },
  couplings: { label: "Die gelernten Kopplungen: Zeilen sagen Spalten voraus", predicts: "über" },
  fit: {
    label: "Wie gut das Modell die Daten erklärt",
    start: "Anfang",
    end: "Ende",
    now: "Jetzt",
    bound: "Schranke",
    boundMeaning: "Die untere Schranke der Evidenz, in Nats: je höher, desto besser",
    mseMeaning:
      "Mittlerer quadratischer Fehler eines Rollouts aller Bilder, nach dynamischer Zeitanpassung jedes Teils",
  },
  verdict: {
    begins: "Das Training beginnt.",
    press:
      "Drücke Trainieren: Hier erscheinen die gelernten Kopplungen, und was sie darüber sagen, wer wen treibt.",
    stopped: (iterations) => `Abgebrochen nach ${iterations} Iterationen`,
    soFar: (iterations) => `Bis jetzt, nach ${iterations} Iterationen`,
    missed: "Verfehlt: Nicht alles, was die Kopplungen sagen, stimmt.",
    driven: "Gefunden: Teil 1 treibt Teil 2, und Teil 2 treibt Teil 1 nicht.",
    neither: "Gefunden: Keiner der Teile treibt den anderen.",
    ratio: (source, target, ratio) =>
      `α von ${source} nach ${target} ist ${ratio}-mal so groß wie α von ${target} nach ${target}:`,
    nothing: (source, target) => `Teil ${source} hat keinen Einfluss auf Teil ${target}. Das stimmt.`,
    seems: (source, target, much) =>
      `Teil ${source} scheint Einfluss auf Teil ${target} zu haben, hat aber keinen; erst ab ${number(much)}-mal zählt es als kein Einfluss.`,
    say: "Teil 1 hat Einfluss auf Teil 2. Das stimmt.",
    tooSmall: (alike) =>
      `zu wenig Einfluss von Teil 1 auf Teil 2; bis ${number(alike)}-mal zählt er als gefunden.`,
    tooLarge: "Teil 1 scheint mehr Einfluss auf Teil 2 zu haben als Teil 2 selbst; das stimmt nicht.",
    tally(found, seeds, driving) {
      const count = `mit ${found} von ${seeds} ${seeds === 1 ? "Startwert" : "Startwerten"} gefunden`;
      return driving ? `${count.replace("mit", "Mit")}.` : `Ohne Einfluss ${count}.`;
    },
    notCounted: (stopped) => `${stopped} abgebrochen, nicht gezählt.`,
  },
  runs: {
    label: "Was jeder Startwert fand",
    progress: (seed) => `Training von Startwert ${seed}`,
    look: "Diesen ansehen",
    lookAt: (seed, driving) => `Startwert ${seed}${driving ? "" : " ohne Einfluss"} ansehen`,
    to: "bis",
    yes: "ja",
    no: "nein",
    waiting: "wartet",
    failed: "gescheitert",
    stopped: "abgebrochen",
    heads: {
      seed: "Startwert",
      driving: "1 treibt 2",
      drivingMeaning: "Ob Teil 1 Teil 2 treibt",
      found: "Gefunden",
      back: "α von 2 nach 1, in Einheiten von α von 1 nach 1",
      forth: "α von 1 nach 2, in Einheiten von α von 2 nach 2",
      bound: "Schranke",
      mse: "Mittlerer quadratischer Fehler des Rollouts",
      explained: "Zustände erklärt",
      explainedMeaning:
        "Der Anteil der wahren latenten Zustände von Teil 1 und von Teil 2, den die gelernten erklären",
      iterations: "Iterationen",
    },
  },
};
