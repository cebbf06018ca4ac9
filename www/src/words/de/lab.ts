import { decimal } from "../../ui/decimal";
import type { LabWords } from "../en/lab";
import { learn } from "./learn";
import { loops } from "./loops";
import { files } from "./files";

const number = (value: number, digits: number) => decimal("de", value, digits);

export const words: LabWords = {
  files,
  learn,
  loops,
  partNames: {
    body: "Körper",
    // As in the story. No sentence about a part has a verb, because some names are plural.
    lower: "Beine",
    upper: "Arme",
    legs: "Beine",
    trunk: "Rumpf",
    "left arm": "linker Arm",
    "right arm": "rechter Arm",
    left: "links",
    right: "rechts",
  },
  splits: {
    whole: "Ganzer Körper",
    "lower-upper": "Beine und Arme",
    "body-arms": "Körper, linker Arm, rechter Arm",
    "legs-trunk-arms": "Beine, Rumpf, linker Arm, rechter Arm",
  },
  title: "Gekoppelte Bewegungs\u00adprimitive",
  lab: "Labor",
  header: {
    files: "Dateien",
    open: "Öffnen",
    openMeaning: "Ein Modell (.json), Clips (.bvh) oder Tabellen (.csv) öffnen",
    help: "Hilfe und Tasten",
    newVersion: "Neue Version laden",
    newVersionMeaning:
      "Es gibt eine neue Version. Sie beginnt von vorn: Speichere zuerst, was du behalten willst.",
  },
  page: {
    panels: { learn: "Lernen", more: "Mehr", numbers: "Zahlen" },
    closePanel: "Diese Tafel schließen",
    skipToCouplings: "Zu den Kopplungen",
    skipToContent: "Zum Inhalt",
    loading: "Wird geladen",
    notLoaded: "Dieser Teil der Seite konnte nicht geladen werden.",
    reload: "Seite neu laden",
    foreignLink: (linked, here) =>
      `Die Kopplungen dieses Links gehören zu einem anderen Modell (${linked}), nicht zu dem auf der Bühne (${here}). Sie gelten, sobald jenes Modell geöffnet ist.`,
    forgetLink: "Vergessen",
    failed: (why) =>
      `Das Modell läuft hier nicht: ${why} Der Gang unten ist gespeichert; Regler und Training brauchen das Modell.`,
    stopped: (why) => `${why} Lade die Seite neu: Sie bietet dann deine Clips und Modelle wieder an.`,
    keepAndReload: "Alles behalten und neu laden",
    local: "Was du lädst, bleibt auf deinem Gerät.",
    leaveLarge: "Projektormodus verlassen",
    leaveLargeKey: "Projektormodus verlassen (Escape)",
    drop: "Clips (.bvh), Tabellen (.csv) oder ein Modell (.json) hier ablegen",
  },
  stage: {
    made: "Vom Modell gemacht",
    lead: {
      drag: "Zieh an einem Pfeil oder seinem α: Bleiben die Teile im Gleichschritt?",
      live: "Halte einen Pfeil oder die Taste c: Das trennt. Zieh am Punkt einer Schleife: Das schiebt den Teil.",
      learning: "Ein Modell lernt: Es bewegt sich, wie es schon kann, und seine Schleifen entstehen.",
      own: "Eigene Kopplungen, nicht die gelernten.",
      clip: "Ein Clip: woraus ein Modell lernt, nicht was es macht.",
      hidden: "Schleifen und Regler gehören zu einer verdeckten Bewegung: Diese Figur ändern sie nicht.",
    },
    rollout: "Ein Rollout",
    clip: "Clip",
    madeBy: (kind) => `Gemacht von einem ${kind}`,
    clipFrom: {
      made: "Ein Clip, von einem Programm gemacht: nicht das Modell",
      model: "Ein Clip, gemacht von einem Modell, das aus Aufnahmen gelernt hat",
      own: "Ein Clip, wie aufgenommen: nicht das Modell",
    },
    point: "Wofür ein Stützpunkt steht",
    posePoint: (part) => `Eine Pose: ${part}`,
    stepPoint: (source, target) => `Von dieser Pose (${source}) zu jener (${target})`,
    changed: "Kopplungen geändert",
    live: "Das Modell läuft live weiter",
    twoReadings: "Dieselben Kopplungen, auf zwei Arten gelesen",
    outline: "Der Umriss bewegt sich, wie das Modell es gelernt hat",
    changeOne: "Ändere eine Kopplung, um zwei Lesarten zu sehen",
    learning: "Das Modell, während es lernt",
    starting: "Beginnt",
    iteration: (iteration, seed) => `Iteration ${iteration}${seed === null ? "" : `, Startwert ${seed}`}`,
    learnedFrom: (names) => `gelernt aus ${names}`,
    clips: (count) => (count === 1 ? "einem Clip" : `${count} Clips`),
    and: (names) => names.join(" und "),
    backToModel: "Zurück zum Modell",
    health: (words, altered) => `${altered ? "Mit diesen Kopplungen: Das Modell" : "Das Modell"} ${words}`,
    asLearned: "Kopplungen wie gelernt",
    playSamples: "Stichproben abspielen",
    samplesMeaning:
      "Stichproben ziehen jeden Schritt aus der Streuung der Vorhersage. Bei drei Menschen rutschten und zitterten sie mehr, als Gänge eines Menschen sich unterscheiden.",
    sampled: (seed) => ({
      title: `Vom Modell gemacht: Stichprobe ${seed}`,
      text: "Jede Runde ist eine andere Bewegung, die das Modell machen könnte",
    }),
    morePoints: "Mit mehr Punkten trainieren",
    morePointsMeaning: (points) => `Trainiert neu mit ${points} Punkten in jeder Abbildung`,
    otherSeeds: "Andere Startwerte",
    otherSeedsMeaning: "Trainiert neu mit den nächsten Startwerten",
    figure:
      "Eine gehende Figur. Ziehen dreht die Ansicht, Scrollen holt sie näher; Tasten: w, a, s, d, plus und minus.",
    figures: (titles) =>
      `${titles.length} Figuren nebeneinander: ${titles.join(", ")}. Ziehen dreht die Ansicht; Tasten: w, a, s, d.`,
    noGraphics:
      "Dieser Browser zeigt keine 3-D-Grafik (WebGL), also kann er die Figur nicht zeichnen. Latente Räume, Kopplungen und Training gehen trotzdem.",
    graphicsLost:
      "Der Browser hat der Seite die 3-D-Grafik genommen, vielleicht weil andere Seiten sie brauchen. Die Figur kommt wieder, sobald er sie zurückgibt; Neuladen hilft vielleicht.",
  },
  clock: {
    clock: "Phasenuhr: ein Zeiger für jeden Teil, der sich in jeder Periode einmal dreht",
    seconds: (seconds) => `${number(seconds, 2)} s`,
    still: "behält eine Pose",
    step: {
      "in step": "im Gleichschritt",
      "partly in step": "teils im Gleichschritt",
      "out of step": "nicht im Gleichschritt",
    },
  },
  presets: {
    label: "Vorgaben",
    own: "Eigene",
    start: {
      "as-learned": { name: "Wie gelernt", meaning: "Beine und Arme, wie das Training sie gekoppelt hat." },
      "arms-go": {
        name: "Arme loslassen",
        meaning:
          "Die Arme hören nicht mehr auf die Beine. Was sie allein tun, wird neu aus den Clips bestimmt.",
      },
      "arms-hang": {
        name: "Arme loslassen, wie sie sind",
        meaning:
          "Die Arme hören nicht mehr auf die Beine. Sie tun, was sie mit den Beinen zusammen gelernt haben.",
      },
      "arms-follow": {
        name: "Arme folgen nur den Beinen",
        meaning: "Die Arme hören nicht mehr auf sich selbst, nur auf die Beine.",
      },
      "arms-lead": {
        name: "Arme führen die Beine",
        meaning: "Die Beine hören nicht mehr auf sich selbst, nur auf die Arme.",
      },
      "untrained-advice": {
        name: "Beine hören etwas auf die Arme",
        meaning: "Die Arme haben über Beine nichts gelernt. Die Beine hören etwas auf sie.",
      },
      "legs-lost": {
        name: "Beine hören kaum auf sich",
        meaning:
          "Die Arme haben über Beine nichts gelernt. Die Beine hören halb auf sich, halb auf die Arme.",
      },
    },
    learned: { name: "Wie gelernt", meaning: "Die Teile, wie das Training sie gekoppelt hat." },
    alone: (part) => ({
      name: `${part} allein`,
      meaning: `Was die anderen Teile über ${part} vorhersagen, zählt kaum.`,
    }),
    follows: (part) => ({
      name: `${part} nach den anderen`,
      meaning: `Wohin ${part} nach der eigenen Vergangenheit gingen, zählt kaum.`,
    }),
  },
  couplings: {
    map: "Kopplungen",
    toOther: (source, target) => `${source} → ${target}`,
    arrow: "Nach oben oder unten ziehen: dicker, dünner. Halten: abschneiden",
    slidersOf: (part) => `Zeigen, was wirkt auf: ${part}`,
    oneSlider: "Die Kopplung mit einem Regler",
    failed: "Das Modell konnte nicht starten, also sind seine Kopplungen nicht zu ändern.",
    empty: "Hier erscheint, wie die Teile einander treiben.",
    onePart:
      "Dieses Modell hat einen [Teil|part], also treibt keiner einen anderen. Trainiere eines mit zwei Teilen oder mehr.",
    completing: "Eine Aufnahme bewegt einen Teil",
    begins: "Wo die Bewegung beginnt",
    startAs: "Beginn wie Clip",
    startLabel: "Beginn wie in",
    trainedOn: "Aus dem Training",
    notTrainedOn: "Nicht trainiert",
    clipStart: (seconds) =>
      `Das Modell erschließt die ersten ${seconds} s aus dem Clip, dann geht es allein weiter. Ein Link behält diesen Beginn nicht.`,
    startFailed: "Die Bewegung kann nicht mit diesem Clip beginnen",
    fromFrame: "ab Bild",
    frame: (frame, count) => `Bild ${frame} von ${count}`,
    decides: "wer",
    about: "über",
    pair: (source, target) => `Alpha von „${source}“ nach „${target}“`,
    tick: (alpha, trained) => `${trained ? "Wie gelernt" : "Wie zuvor"}: ${alpha}`,
    value: (alpha, weight, learned) =>
      `Alpha ${alpha}, Gewicht ${weight}${learned === null ? "" : `; gelernt ${learned}`}`,
    slider: (pair) => `${pair}: Ziehen ändert, Doppelklick setzt zurück`,
    alphaMeaning: "Alpha, die Varianz dieser Vorhersage: Klein heißt einflussreich",
    weightMeaning: "Gewicht dieser Vorhersage; die Gewichte eines Teils ergeben zusammen 1",
  },
  live: {
    hint: "Zieh ein Glied oder dreh das Rad, um einen Teil selbst zu bewegen.",
    driven: (part) => `Du bewegst ${part}. Die anderen folgen, wie die Kopplungen es sagen.`,
    wheel: (part) => `Rad: bewegt ${part} durch den Schritt. Pfeiltasten drehen es, Escape lässt los.`,
    wheelMeaning:
      "Zieh am Rand: Eine Umdrehung ist ein Schrittzyklus. Lass los, und das Modell macht weiter.",
    movers: "Wer jeden Teil bewegt",
    mover: (part) => `Wer ${part} bewegt`,
    model: "das Modell",
    you: "du",
    recording: "eine Aufnahme",
    recorded: (part, title) => `Eine Aufnahme bewegt ${part}: ${title}. Umriss: die Aufnahme.`,
    cuts: (count) => `${count} Kopplungen sind abgeschnitten`,
    cut: (source, target) => `${source} → ${target} ist abgeschnitten`,
    ahead: (part) => `Vorsprung vor ${part}, in Umläufen`,
    distance: "Abstand vom gelernten Zyklus",
    chart: (first, others) =>
      `Verlauf: wie weit ${others.join(", ")} vor ${first} ${others.length > 1 ? "sind" : "ist"}, und wie weit jeder Teil vom gelernten Zyklus entfernt ist`,
    noPhase: "Diese Bewegung wiederholt sich nicht, also gibt es keine Phase zu zeigen.",
    notBegun: "Die Live-Bewegung konnte nicht beginnen",
    ended: "Die Live-Bewegung ist zu Ende",
    stays: "Diese Kopplung bleibt",
    staysWhy: "Nichts anderes würde sagen, wohin der Teil geht.",
  },
  readings: {
    title: "[Experten|expert], wenn sich eine Kopplung ändert",
    label: "Experten",
    about: "Was bedeuten wie gelernt und neu bestimmt?",
    text: { "re-inferred": "neu bestimmt", "as-learned": "wie gelernt" },
    experts: (reading) => `Experten ${reading}`,
    meaning: {
      "re-inferred":
        "Was alles, woraus das Modell lernte, die Vorhersagen jedes Teils unter diesen Kopplungen gelehrt hätten.",
      "as-learned":
        "Nur die Gewichte ändern sich: Jeder Teil sagt voraus wie zuvor und zählt mehr oder weniger.",
    },
    both: "Links, wie gelernt: Das Training machte die Experten zum Team, und einer allein tut nur seinen Anteil. Rechts, neu bestimmt: alles, woraus das Modell lernte, mit diesen Kopplungen neu gelesen; Latente und Kerne bleiben.",
    bothButton: "Beide nebeneinander",
    resetAll: "Zurück",
  },
  measured: {
    compared: (reading) => `Gemessen${reading && `, ${reading}`}:`,
    since: (seconds) => `ab ${number(seconds, 1)} s`,
    still: (since) => `eine Pose ${since}`,
    pose: (since) => `behält eine Pose ${since}`,
    common: (step) => `Hände und Füße ${step}`,
    swingsBy: (centimetres) => `${number(centimetres, 0)} cm weit`,
    swings: (share, hardly) => `${hardly ? "kaum ein Schwung, " : ""}${number(share, 2)} × so weit`,
    noPace: "ohne festes Tempo",
    pace: (is, was) => `${number(is, 2)} s statt ${number(was, 2)} s`,
    speed: (share) => `${number(share, 2)} × so schnell`,
    step: {
      "in step": "im Gleichschritt",
      "partly in step": "teils im Gleichschritt",
      "out of step": "nicht im Gleichschritt",
    },
    aPart: "ein Teil",
    standsStill: (since) => `steht still ${since}`,
    visits: (share, part) => `besucht ${Math.round(100 * share)} % der Posen seiner Clips in ${part}`,
    leaves: (part, since) => `außerhalb des gelernten Bereichs ${since}: ${part}`,
    shakes: (part, times, turnsBack) =>
      `zittert (${part ?? "der ganze Körper"}): ${times === null ? "" : `${number(times, 1)}-mal so schnell wie in den Clips, `}und ${Math.round(100 * turnsBack)} % der Schritte kehren um`,
    runsAway: "läuft davon: Die Zahlen sind zu groß, um sie zu zeigen",
  },
  time: {
    label: "Zeit",
    play: "Abspielen",
    pause: "Pause",
    playMeaning: "Abspielen (Leertaste)",
    pauseMeaning: "Pause (Leertaste)",
    back: "Ein Bild zurück",
    backMeaning: "Ein Bild zurück (Pfeil links)",
    forward: "Ein Bild vor",
    forwardMeaning: "Ein Bild vor (Pfeil rechts)",
    live: "live",
    liveMeaning:
      "Das Modell läuft von hier ohne Ende weiter: Kopplungen abschneiden und Teile schieben, während es geht",
    frame: "Bild",
    frameOf: (frame, count) => `Bild ${frame} von ${count}`,
    length: "Länge der Bewegung in Sekunden",
    lengthMeaning: (least, most) => `Wie lange das Modell läuft, ${least} bis ${most} Sekunden`,
    loop: "Bewegung wiederholen",
    speed: "Tempo",
  },
};
