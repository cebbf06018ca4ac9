import type { CompareWords } from "./en";

export const words: CompareWords = {
  title: "Modelle vergleichen",
  setup: "Was verglichen wird",
  found: "Was dabei herauskam",
  compare: "Vergleichen",
  cancel: "Abbrechen",
  cancelMeaning: "Endet; fertige Trainings bleiben",
  comparing: "Vergleich",
  share: (per100) => `Vergleich, ${per100} Prozent fertig`,
  loadingModels: "Die anderen Modelle werden geladen",
  cancelling: "Wird abgebrochen",
  done: (over, all) => `${over} von ${all} Trainings fertig`,
  failed: (why) => `Der Vergleich ist gescheitert. ${why}`,
  plan: (open, before) =>
    `${open} ${open === 1 ? "Training" : "Trainings"}${before > 0 ? `, ${before} schon fertig` : ""}.`,
  ofItsOwn: " Andere Versuche, Teile oder Bildrate als unten: ein eigener Vergleich.",
  shorter: "Mit weniger Modellen, Versuchen, Startwerten oder Iterationen wird es kürzer.",
  shortWait: "Wie lange es dauert, hängt vom Gerät ab. Die Restzeit steht hier, während es läuft.",
  finishedBefore: "All das war schon fertig.",
  summary: (done, all, failed, cancelled) =>
    `${done} von ${all} Trainings fertig${failed > 0 ? `, ${failed} gescheitert` : ""}${cancelled ? "; die anderen wurden abgebrochen." : "."}`,
  notBegun: "Du hast abgebrochen, bevor es begann.",
  opened: (results) => `${results} Ergebnisse geöffnet.`,
  running: "Ein Vergleich läuft: Brich ihn ab, bevor du Ergebnisse öffnest.",
  noStudy: (why) => `Keine Studie entstand: ${why}`,
  noModelYet: "Hier wurde noch kein Modell trainiert.",
  studyTitle: "Ein Vergleich auf dieser Seite",
  work: (trainings) => `ein Vergleich von ${trainings} ${trainings === 1 ? "Training" : "Trainings"}`,
  whyNot: {
    twoParts: "Die gewählten Modelle brauchen zwei Teile oder mehr",
    gettingReady: "Die Seite wird vorbereitet",
    cannotRun: "Die Modelle laufen in diesem Browser nicht",
    twoClips: "Wähle mindestens zwei Clips: Einer wird zurückgehalten, aus den anderen wird gelernt",
    noTrial: (trial, ticked) => `Es gibt keinen Versuch ${trial}: ${ticked} Clips sind gewählt`,
    oneModel: "Wähle mindestens ein Modell",
  },
  tooLarge: "Diese Datei hat mehr als 200 MB; erwartet werden Ergebnisse eines Vergleichs.",
  openResults: "Ergebnisse öffnen",
  openResultsMeaning: "Ergebnisse (.json) dieser Seite oder des Terminals öffnen",
  saveResults: "Ergebnisse speichern",
  walks: "Zehn aufgenommene Gänge",
  walksMeaning: "Alle Modelle, zehn Gänge einer Person, 30 Bilder je Sekunde",
  makeStudy: "Studie machen",
  makeStudyMeaning:
    "Frage Menschen, welche Bewegung natürlicher ist: eine Studie der hier verglichenen Bewegungen",
  about:
    "Jeder Versuch wird [einmal zurückgehalten|fold]. Jedes Modell lernt aus den anderen, sieht die ersten fünf Bilder des Versuchs und sagt den Rest voraus.",
  given:
    "Alle Modelle mit zehn aufgenommenen Gängen einer Person (CMU, Person 35), früher gemessen: oben vier davon, vom sechsten Bild eines Gangs an. Was du vergleichst, tritt an diese Stelle.",
  lesson:
    "Dass das gekoppelte Modell einen Gang besser voraussagt als zwei einfache, die wissen, dass ein Gang sich wiederholt, fanden wir nicht: Im Mittel von zehn Personen ist der Fehler des vCGPDM, trainiert wie in den Artikeln, 1,15-mal (1,04 bis 1,28) so groß wie der des TMP und 1,18-mal (0,98 bis 1,41) so groß wie der des rhythmischen DMP. Nach der Korrektur für zehn Fragen ist keiner der Unterschiede entschieden. Kopplungen sind dazu da, eine Bewegung zu verändern.",
  failure: (model, trial, why) => `${model}, Versuch ${trial} zurückgehalten: ${why}`,
  models: {
    title: "Modelle",
    whatIs: "Was ist [MAP|map], [TMP|tmp], [DMP|dmp]?",
    about: {
      vcgpdm: "Das gekoppelte Modell dieser Seite, trainiert wie in den Artikeln",
      vgpdm: "Dasselbe, mit dem ganzen Körper als einem Teil",
      "map-gpdm": "Punkte statt Verteilungen als latente Zustände; langsam",
      "map-cgpdm": "Dasselbe, mit gekoppelten Teilen; am langsamsten",
      tmp: "Gewichtete Kurven über einer gemeinsamen Phase",
      "dmp-discrete": "Eine Feder, zu einem Ziel gezogen",
      "dmp-rhythmic": "Eine Feder, um einen Zyklus gezogen",
    },
  },
  trials: {
    title: "Versuche",
    ticked: (ticked, all) => `${ticked} von ${all} Clips gewählt`,
    drop: "Lege eigene Clips (.bvh) irgendwo auf der Seite ab.",
    bottle: {
      about:
        "Zwei Arme, die sich treffen: zehn gemachte Versuche, eine Flasche weiterzugeben, in drei Teilen.",
      load: "Eine Flasche weitergeben",
      found:
        "Auf den zehn Versuchen mit der Flasche sagen drei Teile schlechter vorher als eine TMP, die eine Kurve über der Zeit ist: mit dem 7,59-Fachen ihres Fehlers (4,28 bis 10,90). Ob sie schlechter sind als der ganze Körper als ein Teil, bleibt offen: 2,64-mal so großer Fehler (0,59 bis 5,05).",
      watch: "Im Labor ansehen",
    },
  },
  fields: {
    parts: {
      label: "Teile der gekoppelten Modelle",
      hint: "Wie die gekoppelten Modelle den Körper teilen",
    },
    byHand: (names) => `Von Hand: ${names}`,
    ips: {
      label: "Stützpunkte",
      hint: "Jeder Dynamik und jeder Posenabbildung der Variationsmodelle; mehrere Zahlen zum Vergleich",
    },
    bases: {
      label: "Basen der DMP",
      hint: "Basisfunktionen jeder Spalte der DMP; mehrere Zahlen zum Vergleich",
    },
    comparedIterations: {
      label: "Höchstens Iterationen",
      hint: "Der Optimierung, bei jedem Modell, das eine hat",
    },
    heldOut: {
      label: "Nur Versuch (0: jeder)",
      hint: "Der zurückgehaltene Versuch, ab 1 gezählt; 0: jeder einmal",
    },
    growth: {
      label: "Lernzeit über Bildern",
      hint: "Trainiert vCGPDM und MAP CGPDM auch mit weniger Versuchen",
    },
    growthNeeds: "Braucht vCGPDM oder MAP CGPDM und mindestens vier Versuche.",
    growthTimes: "Die Zeiten entstehen, während alle Kerne arbeiten; das Terminal kann allein messen.",
    seed: { label: "Erster Startwert", hint: "Für alles Zufällige" },
    seeds: { label: "Startwerte", hint: "Wie viele, ab dem ersten" },
    latent: { label: "Latente Dimensionen", hint: "Jedes Teils" },
    order: { label: "Bilder der Vorgeschichte", hint: "Die Ordnung der Dynamik" },
    framesPerSecond: {
      label: "Bilder je Sekunde",
      hint: "Mit so vielen Bildern werden die Clips neu abgetastet",
    },
    balanced: {
      label: "Ausgewogene MAP-Modelle",
      hint: "Ihre Dynamik wiegt so viel wie ihre vielen Spalten (Urtasun, Fleet und Fua 2006)",
    },
  },
  beside: {
    noGraphics:
      "Dieser Browser zeigt keine 3-D-Grafik (WebGL), also kann er die Figuren nicht zeichnen. Die Tabellen unten gehen trotzdem.",
    mostChosen: "Höchstens vier: Nimm zuerst eines weg",
    trial: "Zurückgehaltener Versuch",
    models: (most) => `Gezeigte Modelle, höchstens ${most}`,
    noMotions:
      "Eine Datei mit Ergebnissen enthält keine Bewegungen: Drücke Vergleichen mit den Clips, um die Modelle gehen zu sehen.",
    empty:
      "Drücke Vergleichen: Dann gehen die Modelle hier nebeneinander, jedes mit dem wirklichen Versuch als Umriss.",
    stage: (count) =>
      `${count} Vorhersagen des Versuchs nebeneinander, jede mit dem wirklichen Versuch als Umriss. Ziehen dreht die Ansicht; Tasten: w, a, s, d.`,
    about:
      "In Farbe: was das Modell aus den ersten fünf Bildern des Versuchs voraussagt. Umriss: der wirkliche Versuch, darübergelegt.",
    of: (frames) => `von ${frames}`,
    toStage: "Auf die Bühne",
    toStageMeaning:
      "Ins Labor, das Modell, das ohne diesen Versuch trainiert wurde: zum Bewegen, Speichern und Teilen",
  },
  distance: {
    heading: "Abstand vom wirklichen Versuch",
    none: "Nichts wird gezeigt.",
    axis: "Mittlerer Abstand der Gelenke, cm",
    time: "Zeit, Sekunden",
    label: (found) => `Mittlerer Abstand der Gelenke vom wirklichen Versuch: ${found}.`,
    centimetres: (model, distance) => `${model} ${distance} Zentimeter`,
    caption:
      "Bei einem 1,7 m großen Körper, die Hüften auf die wirklichen gelegt. Der Fehler in der Tabelle ist der von Gelenkdrehungen und der Bewegung der Wurzel nach Anpassung der Zeit: Zu früh oder zu spät zählt hier, dort kaum.",
  },
  table: {
    heading: "Fehler, Schranke, Zeit und Größe jedes Modells",
    none: "Noch ist kein Modell trainiert und beurteilt.",
    converged: (per100) => `, ${per100} % konvergiert`,
    standsFor: (settings) => ` (von ${settings} Einstellungen)`,
    noValue: "keine",
    median: (value) => `Median ${value}`,
    model: "Modell und Einstellungen",
    oneSize: "Eine Größe je Modell",
    all: (settings) => `Alle ${settings} Einstellungen`,
    representatives:
      "Von Einstellungen, die sich nur in der Größe unterscheiden, steht hier die, die über die Versuche am häufigsten gewählt wird, nach dem Fehler der Rollouts auf den gelernten Versuchen. Was am besten, höchsten, schnellsten oder kleinsten ist, gilt unter den gezeigten.",
    caption:
      "Der Fehler ist der [mittlere quadratische Fehler nach dynamischer Zeitanpassung|dtw]; die [Schranke|bound] steht in [Nats|nats]. Fehler, Zeit und Größe haben logarithmische Skalen. Die gestrichelte Linie ist der Fehler einer Vorhersage, die sich nicht bewegt.",
    measures: {
      error: { title: "Fehler", unit: "DTW-MSE", best: "bester" },
      bound: { title: "Schranke", unit: "Nats", best: "höchste" },
      training: { title: "Training", unit: "Sekunden", best: "schnellstes" },
      size: { title: "Größe", unit: "gespeicherte Zahlen", best: "kleinste" },
    },
  },
  correlation: {
    heading: "Fehler über Schranke",
    none: "Braucht ein Modell mit Schranke, beurteilt mit drei oder mehr Einstellungen, etwa Zahlen von Stützpunkten.",
    error: "DTW-MSE, logarithmisch",
    bound: "Schranke, Nats",
    labels: (units) => `Beschriftung: ${units}.`,
    allWith: (all) => `Alle mit ${all}.`,
    caption:
      "Wo die Schranke gut führt, fallen die Punkte von links nach rechts: Rangkorrelation nahe −1. Jedes Bild hat eigene Skalen.",
    rank: (rank, settings) =>
      `${rank === null ? "keine Rangkorrelation" : `Rangkorrelation ${rank}`} über ${settings} ${settings === 1 ? "Einstellung" : "Einstellungen"}`,
    tooFew: "zu wenige Einstellungen für mehr",
    smaller: "eine höhere Schranke geht mit einem kleineren Fehler einher",
    larger: "eine höhere Schranke geht mit einem größeren Fehler einher",
    little: "die Schranke sagt wenig über den Fehler",
    finding: (model, rank, says) => `${model}, Fehler über Schranke: ${rank}; ${says}.`,
  },
  growth: {
    heading: "Lernzeit über Bildern",
    none: "Braucht ein Modell, das mit drei oder mehr Anzahlen von Versuchen trainiert ist.",
    seconds: "Sekunden je Iteration, logarithmisch",
    frames: "Gelernte Bilder, logarithmisch",
    caption:
      "Die Zeit wächst mit den Bildern hoch dem Exponenten: 1 heißt doppelte Zeit bei doppelt so vielen Bildern, 3 die achtfache.",
    exponent: (exponent) => (exponent === null ? "kein Exponent" : `Exponent ${exponent}`),
    finding: (lines) => `Sekunden je Iteration über Bildern, beide logarithmisch: ${lines}.`,
  },
  claims: {
    heading: "Was die Artikel sagen",
    none: "Mit den bisher beurteilten Modellen lässt sich keine Aussage der Artikel prüfen.",
    heads: ["Die Artikel sagen", "Wir finden", "Gilt hier"],
    criterion: "Unser Kriterium:",
    answers: { yes: "ja", no: "nein", undecided: "unentschieden" },
    caption:
      "Fehler werden Versuch für Versuch verglichen; die Intervalle decken 95 % ab. Ja und nein stehen nur, wo das ganze Intervall es sagt.",
  },
  finding: {
    oneTrial:
      "Ein Versuch wurde zurückgehalten und vorhergesagt; wie es mit anderen wäre, ist noch nicht bekannt.",
    trials: (least, most) =>
      `Mittelwert ± Standardfehler über ${least === most ? most : `${least} bis ${most}`} Versuche, jeder einmal zurückgehalten und vorhergesagt; die Balken sind die Standardfehler.`,
    lowest: (model) => `${model} hat hier den kleinsten mittleren Fehler, um mehr als beide Standardfehler.`,
    undecided: (one, other) =>
      `Welches Modell hier den kleinsten Fehler hat, ist unentschieden: ${one} und ${other} unterscheiden sich um weniger als ihre Standardfehler zusammen.`,
    own: (ratio, decided) =>
      ` Der Fehler des vCGPDM ist ${ratio}-mal so groß wie der kleinste${decided ? "" : "; auch das ist unentschieden"}.`,
  },
  empty:
    "Noch nichts zu vergleichen. Jedes Modell erscheint hier, sobald sein erster Versuch vorhergesagt ist.",
};
