import { decimal, withComma } from "../decimal";
import type { LearnWords } from "../en/learn";

const number = (value: number, digits = 0) => decimal("de", value, digits);
const times = (count: number) => (count === 1 ? "einmal" : `${count}-mal`);

export const learn: LearnWords = {
  clips: {
    title: "Clips",
    body: "Körper",
    bodyOf: (title) => `Welcher Körper von ${title}`,
    assumed: (why, fps) =>
      `Gelesen mit ${fps} Bildern je Sekunde, denn die eigene Bildzeit ist keine: Gib die Rate an. (${why})`,
    rate: "Bilder je Sekunde",
    rateOf: (title) => `Bilder je Sekunde von ${title}`,
    up: "oben",
    upAxis: (title) => `Achse, die in ${title} nach oben zeigt`,
    frames: (title) => `Bilder von ${title}, die gelten`,
    side: { first: (title) => `Erstes Bild von ${title}`, end: (title) => `Letztes Bild von ${title}` },
    from: "von",
    to: "bis",
    of: (frames) => `von ${frames} Bildern`,
    tick: (title) => `Mit ${title} trainieren`,
    seconds: (seconds) => `${number(seconds, 1)} s`,
    cut: "Schneiden",
    cutOf: (title) => `${title} schneiden`,
    show: (title) => `${title} zeigen`,
    stopShowing: (title) => `${title} nicht mehr zeigen`,
    onStage: "Auf der Bühne zeigen",
    backToModel: "Zurück zum Modell",
    remove: "Entfernen",
    removeOf: (title) => `${title} entfernen`,
    notices: (count) => `${count} ${count === 1 ? "Hinweis" : "Hinweise"}`,
    bonesClash: "Ihre Gelenke sind dieselben, nur die Knochen sind verschieden.",
    firstBones: "Knochen des ersten Clips nehmen",
    bones: (title) =>
      `Alle gewählten Clips lernt das Modell mit den Knochen von ${title}: Die Gelenkwinkel bleiben, der Weg am Boden wird mit der Länge der Beine skaliert.`,
    ownBones: "Eigene Knochen nehmen",
    openOwn:
      "Öffne eigene Clips (.bvh) oder ein Modell (.json), oder lege sie irgendwo auf der Seite ab. Sie bleiben auf diesem Gerät.",
    series: "Zeitreihen",
    seriesView: "ohne Körper (.csv) haben eine eigene Ansicht.",
    samples: "Beispiele, von einem Programm gemacht",
    recorded: "Bewegungen echter Menschen",
    ticked: (ticked, all) => `${ticked} von ${all} gewählt, um ein neues Modell zu trainieren`,
    gettingReady: "Die Beispiele werden vorbereitet",
    trim: (title) => `${title} kürzen`,
    keep: "Behalten",
    trimSide: {
      first: (title) => `Anfang von ${title} kürzen`,
      end: (title) => `Ende von ${title} kürzen`,
    },
    frame: (frame, time) => `Bild ${frame}, ${time}`,
    range: (from, to) => `${from} bis ${to}`,
  },
  parts: {
    choose: "Wähle den Teil eines Gelenks; die Gelenke darunter gehen mit.",
    joints: "Gelenke und ihre Teile",
    member: (name) => `Teil von ${name}`,
    name: (place) => `Name von Teil ${place}`,
    remove: (name) => `Teil ${name} entfernen`,
    heir: {
      joints: "Seine Gelenke gehen an einen anderen Teil",
      columns: "Seine Spalten gehen an einen anderen Teil",
    },
    empty: {
      joints: "Keine Gelenke: nicht im Training",
      columns: "Keine Spalten: nicht im Training",
    },
    add: "Teil hinzufügen",
    free: (place) => `Teil ${place}`,
    noName: "Ein Teil braucht einen Namen.",
    taken: (name) => `Ein anderer Teil heißt „${name}“.`,
  },
  field: {
    atMost: (limit) => `Höchstens ${limit}.`,
    atLeast: (limit) => `Mindestens ${limit}.`,
    about: (label) => `${label}: Was ist das?`,
  },
  settings: {
    parts: "Teile",
    partsToTrain: "Die Teile, die lernen",
    byHand: "Von Hand",
    joints: (count) => `${count} ${count === 1 ? "Gelenk" : "Gelenke"}`,
    latent: { label: "Latente Dimensionen", hint: "Die Dimensionen des latenten Raums jedes Teils" },
    dynamicsIps: { label: "Punkte der Dynamik", hint: "Stützpunkte der Dynamik jeder Kopplung" },
    poseIps: { label: "Punkte der Posen", hint: "Stützpunkte der Posenabbildung jedes Teils" },
    whyPoints: (points, long) =>
      long
        ? `${points} Punkte, weil ein Clip 8 Sekunden oder länger ist.`
        : `${points} Punkte, weil kein Clip 8 Sekunden lang ist.`,
    framesPerSecond: {
      label: "Bilder je Sekunde",
      hint: "Mit so vielen Bildern werden die Clips neu abgetastet",
    },
    advanced: "Weitere Einstellungen",
    seed: "Startwert",
    newSeed: "Neuer Startwert",
    trainings: {
      label: "Trainings",
      hint: "Eines für jeden Startwert ab diesem, so viele zugleich, wie dieses Gerät Kerne hat; 0: so viele wie Kerne, höchstens 4",
    },
    order: { label: "Bilder der Vorgeschichte", hint: "Die Ordnung der Dynamik" },
    maxIterations: { label: "Höchste Zahl an Iterationen", hint: "Spätestens hier endet die Optimierung" },
    poseWeight: {
      label: "Gewicht der Posen",
      hint: "ausgewogen: Posen zählen so viel wie die Dynamik, und die latenten Zustände sind leichter vorherzusagen. 1: Das Training maximiert die Schranke",
      value: (weight) => (weight === "balanced" ? "ausgewogen" : withComma(String(weight))),
    },
    asInPapers: {
      label: "Wie in den Artikeln",
      hint: "Gewicht 1 der Posen, kein Lernen aus eigenen Rollouts: Das Training maximiert die Schranke",
    },
  },
  training: {
    title: "Training",
    train: "Trainieren",
    cancel: "Abbrechen",
    cancelMeaning: "Endet hier und behält, was bis jetzt gelernt ist",
    add: "Dazu",
    addMeaning: "Trainiert auch mit den Einstellungen unten, neben den anderen",
    continue: (more) => (more > 0 ? `Fortsetzen, noch ${more}` : "Fortsetzen"),
    continueMeaning: (seed, more) =>
      `Setzt Startwert ${seed} fort${more > 0 ? `, um ${more} Iterationen` : ", als wäre er nicht abgebrochen worden"}`,
    iteration: (iteration) => `Iteration ${iteration}`,
    iterationOf: (iteration, most) => `Iteration ${iteration} von ${most}`,
    settingUp: "Wird vorbereitet",
    stopping: "Wird beendet",
    catchingUp: "Holt auf bis dahin, wo es endete",
    done: (over, all) => `${over} von ${all} Trainings fertig`,
    failed: (why) => `Das Training ist gescheitert: ${why}`,
    share: (per100) => `Training, ${per100} Prozent der Iterationen`,
    started: "Das Training hat begonnen",
    cancelling: "Wird abgebrochen",
    ended: (how) => `Das Training ist zu Ende. ${how}`,
    estimating: "Restzeit wird geschätzt",
    left: (time) => `noch höchstens ${time}`,
    leftAbout: (time) => `noch etwa ${time}`,
    stopsHere: "Endet hier und behält das Beste bis jetzt",
    goingShare: (going, per100) => `${going}, ${per100} Prozent fertig`,
    whyNot: {
      gettingReady: "Die Seite wird vorbereitet",
      cannotRun: "Das Modell läuft in diesem Browser nicht",
      samples: "Die Beispiele werden vorbereitet",
      tick: "Wähle mindestens einen Clip für das Training",
      clash: "Die gewählten Clips passen nicht zusammen; unter Clips steht, warum",
    },
    newModels(trainings, clips, made) {
      const models = trainings === 1 ? "Ein neues Modell" : `${trainings} neue Modelle`;
      const of =
        clips === 1
          ? `dem gewählten ${made ? "Beispiel" : "Clip"} und seinem Körper`
          : `den ${clips} gewählten ${made ? "Beispielen" : "Clips"} und ihrem Körper`;
      return `${models}, aus ${of}.`;
    },
    cost: (time, gigabytes) =>
      `Höchstens etwa ${time}.${gigabytes === null ? "" : ` Es braucht etwa ${number(gigabytes, 1)} GB Speicher.`}`,
    shorter: "Mit weniger Bildern je Sekunde, Punkten oder Iterationen wird es kürzer.",
    days: (days) => `${days} Tage`,
    hours: (hours) => `${number(hours, hours % 1 === 0 ? 0 : 1)} Stunden`,
    about: "Zu diesem Training",
    workerGone: "Der Worker, der es trainierte, läuft nicht mehr.",
    notTakenUp: (seed) => `Das Modell von Startwert ${seed} kam nicht auf die Bühne`,
  },
  ending: {
    settled: "die Schranke steigt nicht mehr",
    iterations: "alle Iterationen sind verbraucht",
    done: "Fertig.",
    left: "Du hast die Seite verlassen; dies ist das Beste bis dahin.",
    stopped: "Du hast abgebrochen; dies ist das Beste bis dahin.",
    notBegun: "Du hast abgebrochen, bevor es begann.",
    jittered: (count) => `Eine Kovarianz brauchte ${times(count)} Jitter auf der Diagonale.`,
    turnedBack: (count) => `Die Suche kehrte ${times(count)} um, wo es keine endliche Zahl gab.`,
    count: (count, state) =>
      `${count} ${{ done: "fertig", cancelled: "abgebrochen", failed: "gescheitert" }[state]}`,
    best: (seed, soFar) => ` Das beste${soFar ? " bis jetzt" : ""}, Startwert ${seed}, ist auf der Bühne`,
    closer: (seed) =>
      `: Seine Bewegung ist näher an den Clips als die von Startwert ${seed} mit höherer Schranke`,
    keepsMoving: "bewegt sich weiter",
    worse: (how, seed, otherHow) =>
      `. Für dieses gilt: ${how}. Für Startwert ${seed} mit höherer Schranke gilt: ${otherHow}`,
    motion: {
      breaksDown: "bricht zusammen",
      rests: "ruht wie aufgenommen",
      farFromClips: (since) => `entfernt sich weit von seinen Clips${since && ` ${since}`}`,
    },
  },
  phases: {
    "couplings-kernels-inducing-points": "Kopplungen, Kerne und Stützpunkte",
    everything: "alles zusammen",
    "own-rollouts": "betrachtet die eigene Bewegung und lernt aus ihr",
  },
  runs: {
    title: "Trainings",
    clear: "Liste leeren",
    state: {
      waiting: "wartet",
      running: "läuft",
      done: "fertig",
      cancelled: "abgebrochen",
      failed: "gescheitert",
    },
    progress: (seed) => `Training von Startwert ${seed}`,
    takeUp: "Dieses Modell auf die Bühne nehmen",
    show: (seed) => `Startwert ${seed} zeigen`,
    best: "das beste",
    remove: (seed) => `Startwert ${seed} entfernen`,
    bound: "Schranke",
    iterations: "Iterationen",
    iterationsHead: "It.",
    time: "Zeit",
    clips: "Clips",
    joints: (name, count) => `${name} (${count} Gelenke)`,
    heads: { framesPerSecond: "Bilder/s", maxIterations: "höchstens", poseWeight: "Gewicht" },
    comparable:
      "Schranken sind nur zwischen Trainings mit denselben Bildern und demselben Gewicht der Posen vergleichbar; das Diagramm zeigt diese.",
  },
  bound: {
    name: "Untere Schranke (ELBO)",
    weighted: "Gewichtete Schranke",
    in: "in",
    nats: "Nats",
    seed: (seed) => `Startwert ${seed}`,
    overIterations: "Die Schranke über den Iterationen",
    empty: "Sie steigt hier, während ein Modell lernt.",
    terms: "Terme der Schranke",
    termsOverIterations: "Die Terme der Schranke über den Iterationen",
    poses: (part) => `Posen, ${part}`,
    dynamics: (part) => `Dynamik, ${part}`,
    entropy: "Entropie",
    firstFrames: "erste Bilder",
  },
};
