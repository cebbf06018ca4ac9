import { decimal } from "../decimal";
import type { PrimitivesWords } from "../en/primitives";

const number = (value: number, digits: number) => decimal("de", value, digits);

/** The movements of the page's library, and whose recordings they learned from. */
const MOVEMENTS: Readonly<Record<string, string>> = {
  walk: "Gehen",
  run: "Laufen",
  jump: "Hampelmann",
  wave: "Winken",
};
const PEOPLE: Readonly<Record<string, string>> = {
  walk: "CMU 35",
  run: "CMU 35",
  jump: "CMU",
  wave: "CMU 141",
};

export const primitives: PrimitivesWords = {
  loading: "Wird geladen",
  tryAgain: "Noch einmal versuchen",
  notOpened: (why) => `Die Bibliothek konnte nicht geöffnet werden: ${why}`,
  notPutTogether: "Diese Primitive ließen sich nicht zusammensetzen",
  doesNotMove: (title) => `${title} bewegt sich nicht`,
  stopped: "Die Figur ist stehen geblieben",
  areas: {
    library: "Die Bibliothek",
    figure: "Die Figur",
    chimera: "Chimäre",
    couplings: "Kopplungen und Mischung",
    imports: "Primitive aus anderen Dateien",
    experiment: "Das Experiment",
  },
  library: {
    made: "Eine Bibliothek aufgenommener Bewegungen",
    learned: (movements, time) =>
      `Sie lernte ${movements.map((name) => `„${name}“`).join(", ")} aus ${time} Bewegung.`,
    source: "Die Aufnahmen gehören nicht zur Seite.",
    unsaved: "Sie ist noch nicht gespeichert.",
    undo: "Zurück zur Bibliothek davor",
    save: "Bibliothek speichern",
    open: "Bibliothek öffnen",
    openMeaning: "Eine Bibliothek von Primitiven (.json) öffnen",
    learnedHere: "Die hier gelernte Bibliothek",
  },
  recorded: {
    about:
      "Modelle haben diese Bewegungen von Aufnahmen gelernt. Hier öffnest du eines. Clips, die es macht, stehen in der Liste darüber: Wähle Clips einer Bewegung und trainiere, dann entsteht dieselbe Figur noch einmal.",
    name: (movement) => MOVEMENTS[movement] ?? movement,
    modelMeaning: (movement) => `Das Modell von „${movement}“ auf die Bühne`,
    clip: (movement, number) =>
      `${MOVEMENTS[movement] ?? movement} ${number}, vom Modell von ${PEOPLE[movement] ?? "einer Aufnahme"}`,
    source: "Die Aufnahmen gehören nicht zur Seite.",
    where: "Zu den Aufnahmen",
  },
  walk: {
    noGraphics:
      "Dieser Browser zeigt keine 3-D-Grafik (WebGL), also sind nur die kleinen Figuren gezeichnet.",
    slots: (title) => `Plätze: ${title}`,
    figure: (title) =>
      `Eine Figur, die ohne Ende weitergeht: ${title}. Ziehen dreht die Ansicht; Tasten: w, a, s, d.`,
    never: "Nie aufgenommen",
    recordedAs: (name) => `Aufgenommen als ${name}`,
  },
  drawer: {
    title: "Primitive",
    about:
      "Was jeder Teil gelernt hat. Drücke auf eines, oder zieh es auf den Körper: Die anderen Teile machen weiter.",
    of: (part) => `Primitive von ${part}`,
    relearned: "neu gelernt",
    save: "Speichern",
    saveOf: (part, name) => `${part}: ${name} speichern`,
    saveMeaning: (origin) => `Dieses Primitiv als Datei speichern. ${origin}`,
    notSaved: (part, name) => `${part}: ${name} wurde nicht gespeichert`,
  },
  gallery: {
    title: "Alle Kombinationen",
    never: "nie aufgenommen",
    recordedAs: (name) => `aufgenommen als ${name}`,
    more: (count) => `Noch ${count} passen hier nicht hin. Setze sie auf dem Körper zusammen.`,
  },
  chimera: {
    title: "Chimäre: zwei Tempos in einem Körper",
    about:
      "Lass jeden Teil langsamer oder schneller durch seine Zeit gehen; 1 ist wie gelernt. Das Tempo ist von uns, nicht aus den Artikeln.",
    tempoOf: (part) => `Tempo von ${part}`,
    times: (tempo) => `${number(tempo, 2)}-mal so schnell wie gelernt`,
    notYet: "noch nicht da",
    locking: (value) => `Gleichschritt ${number(value, 2)}`,
    point: (tempo, strength, text) => `Tempo ${number(tempo, 2)}, Kopplung × ${strength}: ${text}`,
    map: (target, source) =>
      `Wie fest ${target} mit ${source} im Gleichschritt ist, für jedes Tempo und jede Stärke. Pfeiltasten gehen von Punkt zu Punkt.`,
    axes: (target, source, alpha) =>
      `Nach oben: Tempo von ${target}. Nach rechts: wie viel stärker die Kopplung von ${source} zu ${target} ist als jetzt; ihr α, ${alpha}, wird dadurch geteilt. Farbe: 1, wo sich der Unterschied der Phasen nie ändert, 0, wo er alle Werte gleich oft annimmt.`,
    ownWay: "geht eigene Wege",
    inStep: "bleibt im Gleichschritt",
    effects: (tempo, strength) =>
      `Von Tempo zu Tempo ändert sich der Gleichschritt um höchstens ${number(tempo, 2)}, von Stärke zu Stärke um ${number(strength, 2)}.`,
    stripes: (effects) =>
      `Nur Streifen: Das Tempo macht hier wenig aus, die Kopplung entscheidet. ${effects}`,
    leads: "Führt",
    follows: "Folgt",
    make: "Karte berechnen",
    making: "Die Karte",
    empty:
      "Wann bleibt ein Teil noch mit dem anderen im Gleichschritt? Die Karte probiert alle Tempos und Stärken; drücke auf einen Punkt, um ihn gehen zu sehen.",
  },
  couplings: {
    title: "[Kopplungen|coupling]",
    reset: "Zurück",
    about:
      "Rechts ist stark. In einer neuen Kombination haben sich die Teile nie getroffen, also hören sie zuerst kaum aufeinander.",
    clip: "Clip",
    fit: "An diesen Clip anpassen",
    fitting: "Anpassung",
    keep: "In die Bibliothek",
    keepMeaning: "Als Bewegung der Bibliothek, mit diesen Kopplungen",
    stage: "Auf die Bühne",
    stageMeaning: "Als Modell, mit diesen Kopplungen, im Labor",
    fitAbout: "Lernt nur die Kopplungen; die Primitive bleiben.",
    fitted: (how, seconds) => `${how} ${number(seconds, 1)} s.`,
    unexplained: (parts, limit, seconds) => {
      const names = parts.join(" und ");
      return `Keine Kopplung gefunden für ${names}: Alle Vorhersagen über ${names} endeten an der Grenze, α = ${limit}. Diese Primitive erklären ${names} in diesem Clip nicht. „Zurück“ macht die Anpassung rückgängig. ${number(seconds, 1)} s.`;
    },
    rests: {
      keepsPose: (part) => `Eine Pose: ${part}`,
      alone: "allein kommt dieser Teil zur Ruhe",
      decides: (leader, share) => `zu ${Math.round(100 * share)} % bestimmt von: ${leader}`,
      ownRest: "; damit kommen die eigenen Vorhersagen zur Ruhe",
      doesNotDrive: " und treibt diesen Teil unter diesen Kopplungen nicht",
      neverLearned: (leader, part) => `, und ${leader} hat nie gelernt, ${part} zu treiben`,
    },
  },
  morph: {
    title: "Mischung",
    about: "Führt die Vorhersage eines Teils nach und nach von einem seiner Primitive zu einem anderen.",
    fromTo: (part, from, to) => `${part}: von ${from} zu ${to}`,
    share: (share, to) => `${Math.round(100 * share)} Prozent ${to}`,
    towards: (part) => `${part}: zu`,
  },
  imports: {
    add: "Primitive hinzufügen",
    addMeaning: "Die Primitive einer anderen Datei (.json) zu dieser Bibliothek hinzufügen",
    of: (title) => `Primitive aus ${title}`,
    misfit: (why) => `passt so nicht: ${why}`,
    about:
      "Seine Primitive lassen sich hier neu lernen: ihre Dynamik von vorn, während Posenabbildungen und Primitive dieser Bibliothek bleiben. Was die Datei von ihrer Bewegung behält, zeigt, was ihre eigenen Posenabbildungen davon zeigen; ein Clip zeigt alles.",
    from: "Aus",
    kept: "dem, was die Datei behält",
    relearn: "Neu lernen",
    relearning: "Lernt neu",
    dismiss: "Nicht übernehmen",
    busy: "Primitive werden neu gelernt: Warte darauf, oder brich ab.",
    known: "Diese Primitive sind schon in der Bibliothek.",
    added: (names) => `Neu: ${names}.`,
    lost: (each) =>
      `Die Posenabbildungen dieser Bibliothek zeigen nicht: ${each.map(([share, part]) => `${share} von ${part}`).join(" und ")}.`,
  },
  learning: {
    title: "Eine Bibliothek lernen",
    about: (same, own) =>
      `Clips mit demselben Namen sind eine Bewegung. Ein Teil mit „${same}“ hat ein Primitiv für alle Bewegungen; mit „${own}“ hat er eines in jeder. Alle anderen Einstellungen sind die des Trainings im Labor.`,
    same: "gemeinsam",
    own: "eigenes",
    learn: "Lernen",
    going: "Lernt",
    done: "Gelernt",
    hint: "Sie tritt an die Stelle der Bibliothek oben, die sich zurückholen lässt.",
    from: (title) => `Aus ${title} lernen`,
    movement: (title) => `Bewegung von ${title}`,
    gettingReady: "Die Beispiele werden vorbereitet.",
    two: "Wähle Clips von zwei Bewegungen.",
    another: "Wähle auch Clips einer anderen Bewegung.",
  },
  recognition: {
    title: "Welche Bewegung ist das?",
    about:
      "Jede Bewegung der Bibliothek folgt jedem Teil der Aufnahme und sagt, wie wahrscheinlich sie ist; so hat jeder Teil in jedem Moment sein wahrscheinlichstes Primitiv. Die Beine können gehen, während die Arme eine andere Bewegung machen. Wähle Clips, die aneinandergehängt werden, oder lege hier eine Aufnahme desselben Körpers ab.",
    clip: "Clip",
    after: "dann",
    nothing: "nichts",
    recognise: "Erkennen",
    going: "Jede Bewegung folgt der Aufnahme",
    tooFew: "Die Bibliothek hat nur eine Bewegung: Es gibt nichts zu wählen.",
    figure: "Die Aufnahme",
    time: "Zeit",
    segment: (movement, first, end) => `${movement} von ${first} bis ${end} s`,
  },
  lesson: {
    title: "Ist ein gemeinsames Primitiv so gut wie ein eigenes?",
    question:
      "Velychko et al. (2018, Abbildung 7) lassen Gehen und Gehen mit Winken ein Primitiv des Unterkörpers teilen und fragen, ob jede Bewegung so gut vorhergesagt wird wie von einem eigenen Modell. Ihre Antwort: gleich, innerhalb der Standardfehler.",
    method: [
      "Dasselbe mit den zehn gemachten Versuchen dieses Projekts: Einer wird zurückgehalten, aus allen anderen wird gelernt. Fehler nach Zeitanpassung, mal 1.000, mit Standardfehlern. Einmal gemessen, mit",
      "; unten lässt sich ein Versuch in deinem Browser zurückhalten.",
    ],
    errors: "Eine Bibliothek, verglichen mit Modellen einer Bewegung",
    open: "Die Intervalle der Unterschiede enthalten 0: Was besser ist, bleibt mit zehn gemachten Versuchen offen.",
    costs: "Was eine Bibliothek kostet, verglichen mit Modellen einer Bewegung",
    paths: "Latente Wege des unteren und des oberen Körpers, beim Gehen und beim Gehen mit Winken",
    caption: "Die latenten Wege einer Bibliothek: erzeugt (durchgezogen) und wie trainiert (gestrichelt).",
    importTitle: "Primitive in einer anderen Bibliothek",
    importText:
      "Ein Primitiv bedeutet nichts unter den Posenabbildungen eines anderen Trainings: Es wird dort neu gelernt, aus Clips, aus den latenten Zuständen, die seine Datei behält, oder aus eigenen Rollouts. Hier zieht das Gehen in eine Bibliothek des Gehens mit Winken, die nie einen Gang ohne Winken gesehen hat.",
    imports: "Gehen, in einer anderen Bibliothek neu gelernt",
    importFinding:
      "Die Beine verlieren nichts: Die andere Bibliothek kennt gehende Beine. Das meiste davon, wie die Arme eines Gangs gehalten werden, ist nicht unter ihren Posen, und was ihre Posenabbildungen nicht zeigen, kann nicht zurückkommen, was immer die Dynamik lernt.",
    combinationTitle: "Eine Kombination, die niemand aufgenommen hat",
    combinationText:
      "Beine vom Gehen, Arme vom Winken im Stehen: Die Kopplungen werden an die ersten Sekunden einer Aufnahme von beidem angepasst, und jedes Modell sagt dieselben letzten drei Sekunden vorher. Mittel über acht Sätze gemachter Versuche; daneben das Verhältnis zur ersten Zeile mit 95-%-Intervall, und in wie vielen Sätzen es unter 1 ist.",
    combinations: "Eine Kombination von Primitiven, verglichen mit anderen Modellen",
    combinationFinding:
      "Nach einer halben Sekunde bewegt sich ein Modell dieser halben Sekunde gar nicht und hat in allen acht Sätzen den größeren Fehler; nach einer oder zwei Sekunden ist unentschieden, was besser ist. Ob die Kopplungen helfen, ist auch unentschieden: Diese gemachten Arme hören nicht auf die Beine.",
    cells: {
      model: "Modell",
      "0.5 s seen: DTW MSE in % of the variance": "0.5 s gesehen: DTW-MSE in % der Varianz",
      "1 s seen: DTW MSE in % of the variance": "1 s gesehen: DTW-MSE in % der Varianz",
      "2 s seen: DTW MSE in % of the variance": "2 s gesehen: DTW-MSE in % der Varianz",
      "divided by the first row": "geteilt durch die erste Zeile",
      "combination, couplings fitted to the seconds": "Kombination, Kopplungen an die Sekunden angepasst",
      "combination, couplings taken over from both movements":
        "Kombination, Kopplungen von beiden Bewegungen übernommen",
      "combination of parts without coupling": "Kombination von Teilen ohne Kopplung",
      "vGPDM of the seconds alone": "vGPDM der Sekunden allein",
      "vGPDM of the seconds alone, as large as both parts":
        "vGPDM der Sekunden allein, so groß wie beide Teile",
      "vGPDM of both movements and the seconds": "vGPDM beider Bewegungen und der Sekunden",
      movement: "Bewegung",
      trials: "Versuche",
      "alone: DTW MSE x 1000": "allein: DTW-MSE x 1000",
      "library: DTW MSE x 1000": "Bibliothek: DTW-MSE x 1000",
      "library minus alone, paired, with 95 % interval":
        "Bibliothek minus allein, gepaart, mit 95-%-Intervall",
      "library lower in": "Bibliothek kleiner in",
      "alone: seconds": "allein: Sekunden",
      "library: seconds (both movements)": "Bibliothek: Sekunden (beide Bewegungen)",
      "alone: numbers stored": "allein: gespeicherte Zahlen",
      "library: numbers stored (both)": "Bibliothek: gespeicherte Zahlen (beide)",
      "walks predicted by": "Gänge vorhergesagt von",
      "DTW MSE x 1000": "DTW-MSE x 1000",
      "minus the donor, paired, with 95 % interval": "minus Spender, gepaart, mit 95-%-Intervall",
      "of the lower body alone": "nur des Unterkörpers",
      "minus the donor": "minus Spender",
      "not shown by the host's pose maps: lower, upper":
        "von den Posenabbildungen der Bibliothek nicht gezeigt: unten, oben",
      "donor, as trained": "Spender, wie trainiert",
      "both trained together": "beide zusammen trainiert",
      "whole movement, again from clips": "ganze Bewegung, neu aus Clips",
      "whole movement, again from what it remembers": "ganze Bewegung, neu aus dem, was sie behält",
      "whole movement, again from what it generates": "ganze Bewegung, neu aus dem, was sie erzeugt",
      "legs alone, again from clips, with the host's arms":
        "nur die Beine, neu aus Clips, mit den Armen der Bibliothek",
    },
    setUp: "Das Experiment oben einrichten",
    setUpMeaning: (learn) =>
      `Alle zehn Clips in zwei Gruppen, der Unterkörper gemeinsam: Drücke „${learn}“, und sieh, welche Kombinationen gehen.`,
  },
  fold: {
    title: "Hier einen Versuch zurückhalten",
    about:
      "Eine Bibliothek lernt aus allen anderen Versuchen beider Bewegungen, ein Modell aus denen der Bewegung des Versuchs; beide sehen auch seine ersten fünf Bilder und sagen den Rest voraus. Von zwei Startwerten zählt der mit der höheren Schranke.",
    trial: "Versuch",
    quick: "ein Zehntel der Iterationen, für einen ersten Blick",
    start: "Zurückhalten",
    library: "Bibliothek beider Bewegungen.",
    alone: "Modell der einen Bewegung.",
    over: "Fertig.",
    cancelled: "Du hast abgebrochen: Es gibt nichts zu vergleichen.",
    label: "Ein zurückgehaltener Versuch",
    heads: (title, trials) => ["DTW-MSE × 1.000", `${title}, hier`, `alle ${trials} Versuche, gemessen`],
    rows: { alone: "allein", library: "Bibliothek" },
    one: (folds) =>
      `Das ist ein Fold von ${folds}: Welches Modell besser ist, lässt sich daraus nicht sagen.`,
    quickErrors: "Mit einem Zehntel der Iterationen sind die Fehler nicht die der Tabelle.",
    going: "Ein Versuch wird zurückgehalten",
    there: "Die Fehler sind da",
  },
  origin: {
    frames: {
      clips: "Clips von hier",
      remembered: "dem, was seine Datei von ihnen behielt",
      generated: "Rollouts davon",
    },
    more: (first, count) => `${first} und ${count} mehr`,
    unnamed: "nicht genannten Clips",
    how: (iterations, seed) => `${iterations} Iterationen, Startwert ${seed}.`,
    learned: (from, how) => `Gelernt aus ${from}; ${how}`,
    relearned: (primitive, from, frames, how) =>
      `Neu gelernt, nach ${primitive} einer anderen Bibliothek, die aus ${from} lernte: aus ${frames}; ${how}`,
  },
};
