import type { PerceptionWords } from "./en";
import { study } from "./study-de";

const people = (count: number) => `${count} ${count === 1 ? "Versuchsperson" : "Versuchspersonen"}`;

export const words: PerceptionWords = {
  standard: study,
  title: "Was ist natürlich?",
  about:
    "Zwei Bewegungen nebeneinander, eine natürlich, eine von einem Modell gemacht. Je öfter Menschen die des Modells für die natürliche halten, desto besser ist das Modell.",
  setup: "Das Experiment",
  found: "Antworten",
  participant: "Versuchsperson",
  code: "ein zufälliger Code",
  codeMeaning: "Ein Code, kein Name",
  begin: "Beginnen",
  simulate: "Simulieren",
  simulateMeaning: "Das Programm antwortet, um das Experiment auszuprobieren",
  privacy:
    "Diese Seite nimmt niemanden auf und sendet nichts. Antworten bleiben in diesem Browser, bis du sie speicherst oder vergessen lässt.",
  here: "Auf diesem Gerät",
  answersSay: "Was die Antworten sagen",
  elsewhere: "Anderswo durchführen",
  elsewhereText: [
    "Lege die gebaute Seite auf einen beliebigen Webspace, mit deiner Studie als",
    ", und gib ihre Adresse weiter, mit",
    " am Ende. In JATOS ist der gebaute Ordner der Inhalt der Studie (Assets), und",
    "ist die Komponente. Auch dort wird nichts gesendet: Versuchspersonen speichern ihre Datei und geben sie ab.",
  ],
  study: {
    title: "Studie",
    save: "Studie speichern",
    open: "Studie öffnen",
    openMeaning: "Eine Studie (.json) öffnen",
    loading: "Die Studie wird geladen.",
    openFirst: "Öffne eine Studie (.json), um zu beginnen.",
    none: "Es gibt noch keine Studie.",
    tooLarge: "Diese Datei hat mehr als 200 MB; erwartet wird eine Studie.",
    unsaved: (title) => `die Studie „${title}“, wie sie hier gemacht oder geändert wurde`,
    design: (trials, blocks, pause, minutes) =>
      `${trials} Durchgänge${blocks > 1 ? ` in ${blocks} Blöcken, dazwischen mindestens ${pause} Pause` : ""}, etwa ${minutes} ${minutes === 1 ? "Minute" : "Minuten"}.`,
    movements: (natural, generated, failed) =>
      `${natural} natürliche und ${generated} von Modellen gemachte Bewegungen, ${failed === 0 ? "keine" : failed} davon als misslungen markiert.`,
    plan: "Plan",
    plans: {
      class: { name: "Klasse", meaning: "Eine kurze, für eine Klasse" },
      "p3-part-1": { name: "P3, Teil 1", meaning: "Wie im ersten Teil von Knopp et al. (2019)" },
      "p3-part-2": { name: "P3, Teil 2", meaning: "Wie im zweiten Teil von Knopp et al. (2019)" },
      p2: { name: "P2", meaning: "Wie bei Velychko et al. (2018)" },
    },
    planLength: (trials, minutes) => `${trials} Durchgänge, ${minutes} min`,
    points: "Lichtpunkte",
    pointsMeaning: "Punkte an den Gelenken statt grauer Figuren.",
    texts: {
      title: "Was Versuchspersonen lesen",
      consent: "Einwilligung",
      instructions: "Anleitung",
      question: "Frage jedes Durchgangs",
      pause: "Pause",
      end: "Nach dem letzten Durchgang",
      hint: "Eine leere Zeile beginnt einen neuen Absatz. Die Texte werden mit der Studie gespeichert. Texte, die niemand geändert hat, erscheinen in der Sprache der Seite.",
    },
    marks: {
      title: "Aufmerksamkeitsproben",
      hint: "Wähle die, die offensichtlich misslungen sind, für [Aufmerksamkeitsproben|attention-check]. Im Vergleich zählen sie nicht, und wer mehr als 15 % von ihnen für natürlich hält, zählt auch nicht.",
      look: "Neben der natürlichen ansehen",
      lookAt: (id) => `${id} ansehen`,
    },
  },
  riddle: {
    title: "Wer ist das Modell?",
    about:
      "Zwei Gänge als Lichtpunkte. In der Studie dieser Seite ist der natürliche ein Programm, das nach veröffentlichten Kurven des menschlichen Gangs geht; das Modell sah andere Gänge davon. Das zählt in keiner Studie.",
    play: "Lass sie gehen",
    question: "Deine Vermutung:",
    right: "Ja.",
    wrong: "Nein, der andere.",
    score: (found, asked) => `Du hast ${found} von ${asked} gefunden. Wer nur rät, findet etwa die Hälfte.`,
    next: "Nächstes Paar",
  },
  look: {
    label: "Eine Bewegung",
    close: "Schließen",
    natural: "Natürlich",
    generated: "Vom Modell gemacht",
    failed: "Die Bewegung kann nicht gezeigt werden",
  },
  run: {
    agree: "Ich bin einverstanden",
    begin: "Beginnen",
    goOn: "Weiter",
    done: "Fertig",
    wait: (seconds) => `In ${seconds} s geht es weiter.`,
    left: "← Links",
    right: "Rechts →",
    progress: "Beantwortete Durchgänge",
    of: (done, all) => `${done} von ${all}`,
    leave: "Verlassen",
    leaveMeaning: "Die Antworten bis jetzt bleiben: Du kannst später weitermachen",
    notShown: "Die Bewegungen können nicht gezeigt werden",
    noGraphics: "Dieser Browser zeigt keine 3-D-Grafik (WebGL). Antworten lassen sich trotzdem auswerten.",
    stopped: "Das Experiment endete vorzeitig",
    otherTab: "Ein anderer Tab dieses Browsers macht damit weiter.",
    noStudy: "Die Studie dazu ist nicht mehr auf diesem Gerät.",
  },
  participants: {
    label: "Versuchspersonen",
    heads: ["Versuchsperson", "Studie", "Beantwortet"],
    files: "Dateien",
    simulated: "simuliert",
    classCode: "Die Antworten in einem Code, für eine Klasse",
    goOn: "Weiter",
    csv: (name) => `CSV von ${name}`,
    json: (name) => `JSON von ${name}`,
    forget: "Vergessen",
    forgetOf: (name) => `${name} vergessen`,
    sureToForget: (answers, name) =>
      `${answers === 1 ? "Die Antwort" : `Die ${answers} Antworten`} von ${name} vergessen? Auf anderen Geräten gibt es sie nicht, außer du hast sie gespeichert.`,
    notKept: (why) =>
      `Dieser Browser behält die Antworten nicht (${why}): Speichere sie, bevor du die Seite verlässt.`,
    keepsNothing: "er speichert nichts",
    nobody:
      "Auf diesem Gerät hat noch niemand geantwortet. Hier erscheinen die Antworten, während sie kommen, und sie bleiben, wenn der Tab geschlossen wird.",
    allCsv: "Alle als eine CSV",
    allJson: "Alle als ein JSON",
  },
  codes: {
    title: "Codes einer Klasse",
    label: "Ein Code in jeder Zeile",
    analyse: "Codes auswerten",
    notRead: "Die Codes wurden nicht gelesen",
    sign: (found) => `erwartet werden Buchstaben und Ziffern, gefunden wurde „${found}“`,
    notWhole: "erwartet wird ein ganzer Code, gefunden wurde ein falsch getippter oder unvollständiger",
    otherStudy: "erwartet wird ein Code der offenen Studie, gefunden wurde einer von einer anderen",
    line: (line, why) => `Zeile ${line}: ${why}`,
  },
  analysis: {
    here: "Die auf diesem Gerät auswerten",
    open: "Antworten öffnen",
    openMeaning: "Die Antworten (.csv oder .json) einer oder mehrerer Versuchspersonen öffnen",
    save: "Ergebnisse speichern",
    files: "Dateien",
    leaveOut: "Weglassen",
    leaveOutOf: (name) => `${name} weglassen`,
    busy: "Wird ausgewertet",
    empty:
      "Lege die Dateien aller Versuchspersonen hier ab. Die Studie, auf die sie geantwortet haben, muss offen sein.",
    tooLarge: (name) => `${name} hat mehr als 200 MB; erwartet werden Antworten.`,
    notOpened: "Die Antworten wurden nicht geöffnet",
    notSaved: "Die Ergebnisse wurden nicht gespeichert",
    fileNotSaved: (name) => `${name} wurde nicht gespeichert`,
    participants: "Versuchspersonen",
    participantsLabel: "Versuchspersonen der Auswertung",
    heads: [
      "Versuchsperson",
      "Antworten",
      "Bestandene Aufmerksamkeitsproben",
      "Median der Antwortzeit, s",
      "Links",
      "Zählt",
    ],
    unanswered: (count) => `${count} nicht beantwortet`,
    of: (hits, all) => `${hits} von ${all}`,
    noneShown: "keine gezeigt",
    leftOut: "zählt nicht",
    counts: "ja",
    count: (trials, participants, share) =>
      `${trials} Antworten von ${people(participants)}: In ${share} galt die Bewegung des Modells als die natürliche.`,
    excluded: (count, limit) =>
      ` ${count} ${count === 1 ? "zählt" : "zählen"} nicht: weniger als ${limit} der Aufmerksamkeitsproben bestanden.`,
    caught: (trials, hits, probability) =>
      `In ${hits} von ${trials} [Kontrolldurchgängen|catch-trial] gewann die Bewegung, die noch nicht gezeigt worden war: Bei vorher gleichen Chancen sind diese Antworten mit Wahrscheinlichkeit ${probability} Zufall, als kennte niemand die anderen auswendig.`,
    needed: (toTell, forPrecision) =>
      `Eine Einstellung braucht ${toTell} Antworten, um eine Rate, die 0,1 unter einem Halb liegt, von ihm zu unterscheiden (einseitig bei 5 %, Teststärke 0,8), und ${forPrecision}, bis eine Rate, die ein Halb ergab, mit Wahrscheinlichkeit 0,8 höchstens um 0,05 davon abweicht.`,
  },
  figures: {
    needsModel: "Braucht Antworten zu Bewegungen eines Modells.",
    needsBlocks: "Braucht Antworten zu einer TMP oder einer DMP.",
    needsPoints: "Braucht Antworten zu einem vCGPDM oder einem vGPDM.",
    bars: "Balken: eine Standardabweichung der A-posteriori-Verteilung der Rate.",
    moreAnswers: "ln K braucht mehr Antworten",
    tooFew: "zu wenige Einstellungen",
    atMost: (value) => `höchstens ${value}`,
    over: (up, across) => `${up} über ${across}`,
    settings: (what, count) => `${what}, ${count} ${count === 1 ? "Einstellung" : "Einstellungen"}`,
    measures: {
      rate: { name: "Verwechslungsrate", axis: "Verwechslungsrate" },
      mse: { name: "Test-MSE", axis: "Test-MSE" },
      "training-mse": { name: "Trainings-MSE", axis: "Trainings-MSE" },
      bound: { name: "Schranke", axis: "Schranke, Nats" },
      dynamics: { name: "Dynamikteil der Schranke", axis: "Dynamikteil, Nats" },
      pose: { name: "Posenteil der Schranke", axis: "Posenteil, Nats" },
      points: { name: "Stützpunkte (weiches Minimum)", axis: "Stützpunkte, weiches Minimum" },
    },
    logarithmic: (axis) => `${axis}, logarithmisch`,
    poses: "Punkte der Posen",
    dynamics: "Punkte der Dynamik",
    scores: {
      heading: "Verwechslungsrate über jedem Maß",
      caption:
        "Kurven: logistische Regression mit einem Halb als größtem Wert. [ln K|ln-k] vergleicht sie mit der besten Konstante, beide geprüft an Antworten, an die sie nicht angepasst wurden: Über 0 sagt das Maß diese Antworten besser vorher als die Konstante; bei wenigen Einstellungen kann das Zufall sein. Kein Maß hat mehr als die Zahl nach „höchstens“: So viel erreicht die eigene Rate jeder Einstellung. Das weiche Minimum der Zahlen von Stützpunkten der Dynamik und der Posen liegt nahe bei der kleineren.",
    },
    all: {
      heading: "Alle Modelle über dem Testfehler",
      title: "Alle Modelle",
      label: (settings, models) =>
        `Verwechslungsrate über Test-MSE von ${settings} Einstellungen von ${models} Modellen`,
      caption: "Die Kurve ist an alle Einstellungen zugleich angepasst.",
    },
    rates: {
      heading: "Über der Zahl der Primitive oder Basen",
      blocks: { primitives: "Primitive", bases: "Basen" },
      value: (value, count, blocks) =>
        `${value} bei ${count} ${{ primitives: "Primitiven", bases: "Basen" }[blocks]}`,
      caption:
        "Bei 0,5, der gestrichelten Linie, kann niemand die Bewegung des Modells von der natürlichen unterscheiden.",
    },
    maps: {
      heading: "Verwechslungsrate über Stützpunkten",
      label: (model) =>
        `${model}: Verwechslungsrate für jede Zahl von Stützpunkten der Posen und der Dynamik`,
      failed: "misslungen",
      caption: "Weiß: offensichtlich misslungene Modelle, die prüfen, ob Versuchspersonen hinsehen.",
    },
    inducing: {
      heading: "Was Stützpunkte bewirken",
      lines: (measure) => `${measure} für Zahlen von Punkten der Posen`,
      linesOf: (measure, counts) => `${measure}, eine Linie für jede Zahl von Punkten der Posen: ${counts}`,
      caption:
        "Eine Ellipse ist umso breiter, je mehr Stützpunkte der Dynamik eine Einstellung hat, und umso höher, je mehr Stützpunkte der Posen.",
      paper:
        "Wie Abbildung 6 von Velychko et al. (2018), mit dem Fehler auf den Clips, aus denen das Modell lernte. Die Kurve dieses Fehlers über der Schranke ist exponentiell, auf einer logarithmischen Achse eine Gerade: Sie ist nach kleinsten Quadraten an den Logarithmus des Fehlers angepasst.",
    },
    pairwise: {
      heading: "Das Beste jedes Modells",
      model: "Modell und seine besten Einstellungen",
      rate: "Verwechslungsrate",
      aboveHalf: "P(Rate > ½)",
      betterThan: "besser als",
      caption:
        "Jede Zeile: wie wahrscheinlich die beste Einstellung des Modells eine höhere Rate hat als die der Spalte, aus den A-posteriori-Verteilungen beider.",
      order: (probability, order) =>
        `Die wahrscheinlichste Reihenfolge, mit Wahrscheinlichkeit ${probability}: ${order}.`,
    },
  },
};
