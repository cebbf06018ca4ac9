import type { MethodWords } from "./en";

export const words: MethodWords = {
  model: {
    title: "Das Modell",
    latents:
      "Ein Körper ist in Teile geteilt. Zu jedem Bild von Teil i gehört ein [latenter Zustand|latent], ein Punkt in einem Raum mit Q Dimensionen. Wohin er als Nächstes geht, sagt jeder Teil j aus seinen eigenen letzten Bildern voraus, und ein [Produkt der Experten|product-of-experts] (Hinton 1999) verbindet die Vorhersagen:",
    weights:
      "Je kleiner eine Kopplungsvarianz ist, desto größer ist das Gewicht dieses Experten. Nur die Verhältnisse der Varianzen, die zu einem Teil führen, ändern den Mittelwert. Jeder Experte ist ein Gaußprozess. Seine Signalvarianz ist 1: Sonst könnte seine Größe das Gewicht ersetzen.",
    poses:
      "Eine [Posenabbildung|pose-map], auch sie ein Gaußprozess, macht aus dem latenten Zustand die Pose des Teils:",
  },
  training: {
    title: "Training",
    bound:
      "Die latenten Zustände sind nicht bekannt. Darum findet das Training für jeden eine Gaußverteilung, zusammen mit Kernen, Kopplungen und Stützpunkten. Es erhöht die Summe",
    weights:
      "Mit γ = 1, wie in den Artikeln, ist das eine untere Schranke der logarithmierten Evidenz. Im Labor ist γ für einen Körper sonst gleich Q/D, latente Dimensionen durch Spalten des Teils: keine Schranke, aber latente Zustände, die leichter vorherzusagen sind (Urtasun et al. 2006). Ein Modell eines Körpers, dessen Bewegung nicht weitergeht, lernt dann aus eigenen Rollouts, die nur die Verteilung von u ändern. „Wie in den Artikeln“, unter Lernen, trainiert mit γ = 1 und ohne eigene Rollouts, wie es „Modelle vergleichen“ immer tut; eine Bibliothek, die du lernst, hat γ = 1.",
    terms:
      "Jeder Term F eines Gaußprozesses stützt sich auf wenige Stützpunkte statt auf alle Bilder (Titsias und Lawrence 2010). Für R Zeilen und C Spalten, mit der Varianz n des Beobachteten und der Kovarianz K der Stützpunkte:",
    sums: "Ψ₂ und b sind Summen erwarteter Produkte über die Bilder: zweier Werte des Kerns, und eines Werts des Kerns mit dem Beobachteten. c₂ ist die Summe der erwarteten Quadrate des Beobachteten, und Δ das, was die Stützpunkte nicht erklären. Die Zeit einer Iteration wächst linear mit der Zahl der Bilder.",
  },
  steps: {
    title: "Woher die Schranke kommt",
    list: [
      "Jede Abbildung bekommt Stützpunkte: einige Eingaben und die Ausgaben dort. Sind sie bekannt, so gilt der Rest der Abbildung als unabhängig von den Daten.",
      "An die Stelle der wahren Verteilung tritt eine Gaußverteilung für jeden latenten Zustand, eine für die Ausgaben an den Stützpunkten jeder Abbildung auf Posen und eine für die aller Experten über einen Teil zusammen. Die jensensche Ungleichung begrenzt dann die logarithmierte Evidenz von unten.",
      "Über die Abbildungen wird integriert. Die beste Verteilung der Ausgaben an den Stützpunkten hat eine geschlossene Form: 𝐄(u) oben.",
      "Die Werte des Kerns werden über die latenten Zustände gemittelt. Für diesen Kern sind die Mittelwerte exakt: Nichts wird zufällig gezogen.",
    ],
  },
  rollout: {
    title: "Rollout",
    text: "Ein Rollout beginnt mit den ersten p latenten Zuständen eines Clips und sagt dann Bild für Bild voraus, alle Teile zusammen:",
    mean: "Jeder Schritt ist der Mittelwert seiner Vorhersage, ohne Zufall.",
  },
  readings: {
    title: "Zwei Lesarten einer Kopplung",
    learned: "Experten wie gelernt.",
    learnedText:
      "Ein Regler ändert α und damit die Gewichte, wie in den Artikeln. Was jeder Experte vorhersagt, bleibt: Was wäre, wenn dieser Teil weniger auf jenen hörte?",
    inferred: "Experten neu bestimmt.",
    inferredText:
      "Unter anderen Kopplungen hätten dieselben Daten andere Experten gelehrt. Das Modell behält die Summen Ψ₂ und b über alles, woraus es lernte, auch eigene Rollouts; damit lässt sich 𝐄(u) für jedes α neu berechnen. Oft lassen sich die Daten auch unter diesen Kopplungen erklären, und die Bewegung bleibt fast gleich.",
    choose: "Lesart wählen",
  },
  others: {
    title: "Die anderen Modelle",
    tmp: "[TMP|tmp] (nach Clever et al. 2016): Jede Spalte ist eine gewichtete Summe weniger Kurven über einer gemeinsamen Phase.",
    dmp: "[DMP|dmp] (Ijspeert et al. 2013): Eine Feder zieht jede Spalte zu einem Ziel g, und eine gelernte Kraft f folgt einer vorgegebenen Uhr s.",
    map: "[MAP|map] (Wang et al. 2008; Velychko et al. 2014): dieselbe Dynamik wie oben, mit allen Bildern statt Stützpunkten, und mit den wahrscheinlichsten latenten Zuständen statt Verteilungen.",
    score: "Die Verwechslungsrate",
    scoreText:
      "Beim vCGPDM fanden Velychko et al. (2018), dass Menschen eine Bewegung umso seltener für die natürliche halten, je größer ihr Fehler auf den Trainingsdaten ist, und passen a und c an; 0,5 wäre vollkommen. Bei DMPs und dem Fehler auf zurückgehaltenen Versuchen fanden Knopp et al. (2019) keine solche Kurve.",
  },
  table: {
    label: "Eigenschaften der Modelle (Velychko et al. 2018, Tabelle 1)",
    model: "Modell",
    properties: ["modular", "skalierbar", "kompakt", "kanonische Dynamik", "gelernte Dynamik"],
    yes: "ja",
    no: "nein",
    see: "Siehe",
    measuredBy: ", für GPDMs gemessen mit",
    evidence: {
      modular: {
        property: "modular",
        meaning: "Seine Primitive lassen sich in anderen Bewegungen wieder verwenden",
      },
      scalable: {
        property: "skalierbar",
        meaning: "Bei vielen Bildern wächst die Zeit einer Iteration weniger als mit ihrer dritten Potenz",
      },
      compact: {
        property: "kompakt",
        meaning: "Was ein Rollout braucht, wächst nicht mit der Zahl der Bilder",
      },
      dynamics: {
        property: "kanonische und gelernte Dynamik",
        meaning: "Die Dynamik ist vor dem Lernen gegeben, oder sie ist eine beliebige glatte Funktion",
      },
    },
  },
  graphs: {
    one: "Grafisches Modell eines Teils",
    oneText:
      "Jeder latente Zustand folgt aus den beiden davor und gibt eine Pose. Wenige Stützpunkte (Rauten) stehen für beide Abbildungen.",
    two: "Grafisches Modell zweier gekoppelter Teile",
    twoText:
      "Zwei Teile. Jeder sagt auch den nächsten latenten Zustand des anderen voraus; die Posen sind weggelassen. Drücke auf eine Form: Sie führt zu ihrem Regler.",
    part: (place) => `Teil ${place}`,
    latents: "Latente Zustände: ihre Bilder zeigen",
    bothLatents: "Latente Zustände von Teil 1 und Teil 2: ihre Bilder zeigen",
    poses: "Posen: die Figur zeigen",
    dynamicsPoints: "Stützpunkte der Dynamik: in den Bildern zeigen",
    posePoints: "Stützpunkte der Posen: in den Bildern zeigen",
    couplings: "Kopplungen: ihre Regler zeigen",
  },
  equation: (name) => `Gleichung: ${name}`,
  equations: {
    dynamics: "der nächste latente Zustand",
    weights: "die Gewichte der Experten",
    history: "die Vorgeschichte eines Teils",
    expert: "ein Experte",
    kernel: "der Kern",
    pose: "die Posenabbildung",
    bound: "was das Training maximiert",
    collapsed: "ein Term der Schranke",
    posterior: "die Ausgaben an den Stützpunkten",
    rollout: "ein Schritt des Rollouts",
    tmp: "das zeitliche Bewegungsprimitiv",
    dmp: "das dynamische Bewegungsprimitiv",
    map: "die MAP-Modelle",
    score: "die Verwechslungsrate",
  },
  inEquations: {
    poses: "Posen ",
    dynamics: "Dynamik ",
    firstFrames: "erste Bilder",
    entropy: "Entropie",
    natural: "für natürlich gehalten",
  },
  symbols: {
    title: "Die Zeichen, und wo sie auf der Seite sind",
    label: "Zeichen",
    heads: ["Zeichen", "Bedeutung", "Auf der Seite"],
    notShown: "nicht gezeigt",
    meaning: {
      parts: "Teile des Körpers: j sagt i voraus",
      frames: "Bild, ab 0 gezählt",
      pose: "die Pose von Teil i: Gelenkwinkel, und wie sich die Wurzel bewegt",
      latent: "latenter Zustand: die Pose von Teil i in wenigen Zahlen",
      dimensions: "Dimensionen eines latenten Raums",
      history: "die letzten p latenten Zustände von Teil j",
      order: "Ordnung der Dynamik",
      expert: "Experte: was Teil j über Teil i vorhersagt",
      coupling: "Kopplungsvarianz: Klein heißt einflussreich",
      weight: "Gewicht eines Experten, 0 bis 1",
      dynamicsPoints: "Stützpunkte der Dynamik: Vorgeschichten, und was auf sie folgt",
      dynamicsCount: "wie viele davon jeder Experte hat",
      poseMap: "Posenabbildung: von latenten Zuständen zu Posen",
      posePoints: "Stützpunkte der Posen, und ihre Posen",
      poseCount: "wie viele davon jede Posenabbildung hat",
      noise: "Varianz des Rauschens der Posen von Teil i",
      lengths: "quadrierte Längenskala: bis zu welchem Abstand sich zwei latente Zustände noch gleichen",
      bound: "untere Schranke der Evidenz, in Nats",
    },
    there: {
      parts: "Teile: wie der Körper geteilt ist",
      frames: "die Zeitleiste",
      pose: "die Figur",
      latent: "der Punkt in seinem Bild",
      dimensions: "Latente Dimensionen",
      order: "Bilder der Vorgeschichte",
      expert: "wie gelernt oder neu bestimmt",
      coupling: "die Regler",
      weight: "die Zahlen unter den Reglern",
      dynamicsPoints: "die Pfeile in den Bildern",
      dynamicsCount: "Punkte der Dynamik",
      posePoints: "die Rauten in den Bildern",
      poseCount: "Punkte der Posen",
      bound: "das Diagramm unter Training",
    },
  },
  references: {
    title: "Literatur",
    cite: "Bitte zitiere diese Artikel",
    save: "Als BibTeX speichern",
  },
  back: "Zurück zum Gang",
};
