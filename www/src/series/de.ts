import type { SeriesWords } from "./en";

export const words: SeriesWords = {
  setup: "Tabellen und Training",
  tables: "Tabellen",
  open: "Öffnen",
  openMeaning: "Tabellen (.csv) oder ein Modell von Tabellen (.json) öffnen",
  drop: [
    "Lege CSV-Dateien irgendwo ab, eine je Versuch: Namen in der ersten Zeile, dann eine Zeile Zahlen je Zeitpunkt. Eine Spalte",
    "enthält Sekunden. Die Dateien bleiben auf diesem Gerät, und nur solange diese Seite offen ist.",
  ],
  train: "Trainieren",
  training: "Training",
  trained: "Trainiert",
  hint: "Lernt, wie die Spalten jedes Teils weitergehen, und wie viel die Vergangenheit jedes Teils über die anderen sagt.",
  openFirst: "Öffne eine Tabelle, oder wähle eine.",
  clash: "Die gewählten Tabellen passen nicht zusammen.",
  fields: {
    latent: { label: "Latente Dimensionen", hint: "Die Dimensionen des latenten Raums jedes Teils" },
    dynamicsIps: { label: "Punkte der Dynamik", hint: "Stützpunkte der Dynamik jeder Kopplung" },
    poseIps: {
      label: "Punkte der Beobachtung",
      hint: "Stützpunkte der Abbildung vom latenten Zustand jedes Teils auf seine Spalten",
    },
    order: { label: "Zeilen der Vorgeschichte", hint: "Die Ordnung der Dynamik" },
    maxIterations: { label: "Höchstens Iterationen", hint: "Spätestens hier endet die Optimierung" },
    seed: { label: "Startwert", hint: "Der Startwert für alles Zufällige" },
    framesPerSecond: {
      label: "Zeilen je Sekunde",
      hint: "Wie schnell die Zeilen aufeinander folgen: Die Tabellen haben keine Spalte mit Zeiten",
    },
  },
  begin: {
    title: "Kurven, die kein Körper sind",
    text: "Kräfte, Gelenkmomente, Muskelaktivität, Preise, zwei Maschinen: was immer du mehrfach zugleich gemessen hast. Spalten kommen in Teile; jeder Teil bekommt einen latenten Raum, und die Kopplungen sagen, wessen Vergangenheit welchen Teil vorherzusagen hilft. Ein Modell von Tabellen ist eine Datei wie alle anderen.",
    example: "Ein Beispiel öffnen",
    machines: "Zwei erdachte Maschinen, aus einer Formel; die zweite folgt der ersten etwas später.",
  },
  leaveOut: {
    label: "Weglassen",
    hint: "Namen von Spalten, mit Kommas dazwischen. * am Anfang oder Ende steht für beliebige Zeichen",
  },
  parts: "Teile",
  columns: "Spalten und ihre Teile",
  size: (rows, columns, seconds) => `${rows} Zeilen zu ${columns}${seconds === null ? "" : `, ${seconds}`}`,
  row: "Zeile",
  rowOf: (row, rows) => `Zeile ${row} von ${rows}`,
  of: (rows) => `von ${rows}`,
  curves: "Kurven",
  startAs: "Beginn wie",
  saveCurves: "Kurven, CSV",
  saveCurvesMeaning: "Eine Zeile je Bild, eine Spalte je Kurve",
  saveModel: "Modell, JSON",
  saveModelMeaning: "Öffnet sich hier und im Terminal",
  recorded:
    "In Farbe: das Modell allein, ab den ersten Zeilen der Tabelle, oder was es aus gegebenen Spalten erschließt. Gestrichelt: was aufgenommen wurde.",
  notRecorded:
    "Das Modell allein. Seine Datei enthält nicht, was aufgenommen wurde: Öffne die Tabellen, um es gestrichelt zu sehen.",
  provenance: (engine, iterations, seed) =>
    `Trainiert von ${engine}, ${iterations} Iterationen, Startwert ${seed}.`,
  noCouplings:
    "Von einem solchen Modell stehen hier nur die Kurven, keine Kopplungen und keine latenten Räume.",
  overTime: "Spalten über der Zeit",
  figure: "Die Spalten NAME.x, NAME.y und NAME.z als Punkte, durch Knochen verbunden",
  time: "Zeit (s)",
  curve: (name, recorded) => `${name} über der Zeit, ausgerollt${recorded ? " und aufgenommen" : ""}`,
  givers: {
    who: (name) => `Wer ${name} gibt`,
    model: "das Modell",
    recording: "die Aufnahme",
    hand: "von Hand",
    draw: (name) =>
      `${name} von Hand: Ziehen zeichnet die Kurve, die Pfeiltasten biegen sie zur gezeigten Zeit.`,
  },
  unsaved: "das Modell von Tabellen, das hier trainiert wurde",
  noModel: "Es gibt noch kein Modell: Trainiere eines, oder öffne eines.",
};
