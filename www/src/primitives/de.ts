import { decimal } from "../ui/decimal";
import type { PrimitivesWords } from "./en";

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

export const words: PrimitivesWords = {
  loading: "Wird geladen",
  tryAgain: "Noch einmal versuchen",
  notOpened: (why) => `Die Bibliothek konnte nicht geöffnet werden: ${why}`,
  notPutTogether: "Diese Primitive ließen sich nicht zusammensetzen",
  doesNotMove: (title) => `${title} bewegt sich nicht`,
  areas: {
    library: "Die Bibliothek",
    figure: "Die Figur",
    chimera: "Chimäre",
    couplings: "Kopplungen",
    imports: "Primitive aus anderen Dateien",
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
      "Modelle haben diese Bewegungen von Aufnahmen gelernt. Hier öffnest du eines. Clips, die es macht, stehen in der Liste darüber: Wähle Clips einer Bewegung und trainiere daraus ein eigenes Modell.",
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
  },
  couplings: {
    title: "[Kopplungen|coupling]",
    reset: "Zurück",
    about:
      "Rechts ist stark. In einer neuen Kombination haben sich die Teile nie getroffen, also beginnen ihre Kopplungen an der schwachen Grenze, und nur ein Teil, der auf sich selbst kaum hört, hört den anderen noch.",
    clip: "Clip",
    fit: "An diesen Clip anpassen",
    fitting: "Anpassung",
    keep: "In die Bibliothek",
    keepMeaning: "Als Bewegung der Bibliothek, mit diesen Kopplungen",
    stage: "Auf die Bühne",
    stageMeaning: "Als Modell, mit diesen Kopplungen, im Labor",
    cut: "kappen",
    cutOf: (source, target) => `${source} → ${target} kappen, solange gehalten`,
    cutMeaning: "Solange gehalten, ist diese Kopplung gekappt",
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
  imports: {
    add: "Primitive hinzufügen",
    addMeaning: "Die Primitive einer anderen Datei (.json) zu dieser Bibliothek hinzufügen",
    known: "Diese Primitive sind schon in der Bibliothek.",
    added: (names) => `Neu: ${names}.`,
  },
  learning: {
    title: "Eine Bibliothek lernen",
    about: (same, own) =>
      `Clips mit demselben Namen sind eine Bewegung. Ein Teil mit „${same}“ hat ein Primitiv für alle Bewegungen; mit „${own}“ hat er eines in jeder. Andere Einstellungen sind die des Trainings im Labor, nur haben die Posen das Gewicht 1, es gibt ein Training, Bewegungen lernen aus eigenen Rollouts, und ein Teil hat 12 Punkte jeder Art, wenn keine Zahl gewählt ist.`,
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
