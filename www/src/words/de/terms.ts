import type { TermsWords } from "../en/terms";

export const terms: TermsWords = {
  more: "Die Methode mit ihren Gleichungen",
  texts: {
    alpha: {
      title: "Kopplungsvarianz",
      words:
        "Die Varianz dessen, was ein Teil über einen anderen vorhersagt: Je kleiner sie ist, desto mehr zählt diese Vorhersage. Das Training hält sie zwischen 0,001 und 10; eine gelernte 10 heißt also, dass die Vorhersage nicht gebraucht wurde.",
    },
    weight: {
      title: "Gewicht",
      words:
        "Der Anteil einer Vorhersage an der gemeinsamen, von 0 bis 1. Die Gewichte eines Teils ergeben zusammen 1: Steigt eines, so fallen die anderen.",
    },
    coupling: {
      title: "Kopplung",
      words:
        "Wie stark ein Teil einen anderen treibt oder sich selbst. Jeder Teil sagt den nächsten Zustand jedes Teils voraus, und die Kopplungen sagen, wessen Wort zählt.",
    },
    expert: {
      title: "Experte",
      words:
        "Was ein Teil über den nächsten latenten Zustand eines Teils vorhersagt, auch über seinen eigenen. Jeder Experte ist ein Gaußprozess, der nur die letzten Bilder des eigenen Teils sieht.",
    },
    "product-of-experts": {
      title: "Produkt der Experten",
      words:
        "Die Regel, die die Experten verbindet: Ihre gaußschen Vorhersagen werden multipliziert. Heraus kommt ihr gewichteter Mittelwert, und der Experte mit der kleinsten Varianz α hat das größte Gewicht.",
    },
    predictions: {
      title: "Vorhersagen, gezeichnet",
      words:
        "Die Vorhersage jedes Teils für den Zustand jetzt ist ein Kreis in seiner Farbe, mit einer Standardabweichung als Radius; dünne Linien führen zu ihrem Produkt in Schwarz (weiß auf dunkler Seite), gestrichelte haben ein Gewicht unter 0,01. Der Pfeil ist der Schritt vom Zustand davor, und das Band um den Weg ist so breit, wie das Produkt unsicher ist.",
    },
    reading: {
      title: "wie gelernt, neu bestimmt",
      words:
        "Wie gelernt: Ein Regler ändert nur die Gewichte, und jeder Experte sagt voraus wie zuvor. Neu bestimmt: Die Experten werden neu berechnet, so wie alles, woraus das Modell lernte, sie unter diesen Kopplungen gelehrt hätten; oft bleibt die Bewegung dann fast gleich, weil andere Experten übernehmen.",
    },
    measured: {
      title: "Messwerte",
      words:
        "Aus 20 Sekunden dieser Bewegung, ohne die ersten 5, in denen sie ihr Tempo findet: wie weit Hände und Füße schwingen, als Vielfaches der Bewegung wie gelernt. Im Gleichschritt heißt, dass jede Hand ihren Platz im Zyklus des Fußes der anderen Seite behält.",
    },
    part: {
      title: "Teil",
      words:
        "Eine Gruppe von Gelenken, etwa die Beine, mit einem gemeinsamen latenten Raum und einer Farbe. Ein Körper lässt sich in bis zu acht Teile teilen.",
    },
    latent: {
      title: "latenter Zustand",
      words:
        "Ein Punkt, der für eine Pose eines Teils steht, mit wenigen Zahlen statt vieler Gelenkwinkel. Das Modell findet die latenten Zustände aller Bilder selbst.",
    },
    "latent-space": {
      title: "latenter Raum",
      words:
        "Der Raum der latenten Zustände eines Teils: Nahe Punkte sind ähnliche Posen, und ein Gang ist eine Schleife darin. Er hat Q Dimensionen; die Bilder hier zeigen ihn von der Seite, von der er am breitesten ist.",
    },
    "inducing-point": {
      title: "Stützpunkt",
      words:
        "Eines der wenigen Beispiele, die das Modell statt aller Bilder behält. Die der Posenabbildung sind Posen; die der Dynamik sind kurze Stücke Bewegung und das, was darauf folgt.",
    },
    "dynamics-points": {
      title: "Stützpunkte der Dynamik",
      words:
        "Wie viele kurze Stücke Bewegung jeder Experte behält. Mehr davon können eine reichere Bewegung beschreiben, und das Training dauert länger.",
    },
    "pose-points": {
      title: "Stützpunkte der Posen",
      words:
        "Wie viele Posen die Posenabbildung jedes Teils behält. Mehr davon geben feinere Posen, und das Training dauert länger.",
    },
    "pose-map": {
      title: "Posenabbildung",
      words:
        "Der Gaußprozess, der aus einem latenten Zustand eine Pose seines Teils macht. Er wird zusammen mit den latenten Zuständen und der Dynamik gelernt.",
    },
    lengthscale: {
      title: "Längenskala",
      words:
        "Wie weit man entlang einer latenten Dimension gehen muss, bis die Funktion eines Gaußprozesses eine andere ist. Eine Dimension, deren Längenskala viel länger ist als der latente Weg, spielt kaum eine Rolle.",
    },
    "signal-variance": {
      title: "Signalvarianz",
      words:
        "Wie weit die Funktion eines Gaußprozesses auf und ab geht, als Varianz. Bei einer Posenabbildung steht sie in den quadrierten Einheiten der Spalten der Pose, meist Radiant.",
    },
    "noise-variance": {
      title: "Beobachtungsrauschen",
      words:
        "Die Varianz dessen, was die Posenabbildung eines Teils in seinen Spalten nicht erklärt. Sie ist klein, wo das Modell den aufgenommenen Posen genau folgt.",
    },
    order: {
      title: "Ordnung der Dynamik",
      words:
        "Wie viele frühere Bilder das nächste vorhersagen. Mit zweien weiß das Modell, wo ein Teil ist und wie schnell er sich bewegt.",
    },
    bound: {
      title: "untere Schranke der Evidenz",
      words:
        "Wie gut das Modell die Clips erklärt, abzüglich dessen, was das Erklären kostet. Das Training erhöht sie oder, im Labor meist, ihre Summe mit kleineren Gewichten der Posen; Schranken sind nur zwischen Modellen derselben Bilder vergleichbar.",
    },
    "bound-terms": {
      title: "Terme der Schranke",
      words:
        "Die Schranke ist eine Summe: wie gut Posen und Dynamik jedes Teils erklärt sind, die ersten Bilder, und die Entropie der latenten Zustände. Knopp et al. (2019) fanden, dass die Dynamik mehr als die Posen darüber sagt, wie natürlich das Gehen eines Modells aussieht.",
    },
    nats: {
      title: "Nat",
      words:
        "Die Einheit der Schranke: Information, mit dem natürlichen Logarithmus gezählt. Ein Nat sind 1,44 Bit.",
    },
    iterations: {
      title: "Iteration",
      words:
        "Ein Schritt der Optimierung, die die Zahlen des Modells (zuerst alle außer den latenten Zuständen) so ändert, dass die Zielfunktion steigt. Das Training endet, wenn sie nicht mehr steigt oder nach so vielen Schritten.",
    },
    seed: {
      title: "Startwert",
      words:
        "Die Zahl, aus der alle Zufallszahlen eines Trainings folgen. Derselbe Startwert gibt dasselbe Modell; ein anderer findet vielleicht ein besseres oder ein schlechteres.",
    },
    "movement-primitive": {
      title: "Bewegungsprimitiv",
      words:
        "Ein Baustein der Bewegung, etwa ein Schrittzyklus der Beine. Dieses Modell lernt einen für jeden Teil, und Kopplungen machen daraus eine Bewegung.",
    },
    rollout: {
      title: "Rollout",
      words:
        "Eine Bewegung, die das Modell macht: Sie beginnt mit einigen Bildern eines Clips und sagt dann Bild für Bild aus den eigenen Vorhersagen voraus. Hier ist jeder Schritt der Mittelwert der Vorhersage.",
    },
    future: {
      title: "Zukunft",
      words:
        "Eine zufällig gezogene Bewegung: In jedem Bild ist der nächste Zustand nicht der Mittelwert der Vorhersage, sondern ein Zug aus ihr. Derselbe Startwert zieht dieselbe; in den Bildern steht eine Zukunft mit der letzten halben Sekunde ihres Wegs.",
    },
    "moment-matching": {
      title: "Moment-Matching",
      words:
        "Was über den Zustand bekannt ist, wenn nur die ersten Bilder sicher sind: Mittelwert und Streuung, von Bild zu Bild als Gaußverteilung weitergegeben. Eine Gaußverteilung kann sich nicht um eine Schleife biegen: Bei den Beinen des Startmodells sagen die Zukünfte nach etwa zwei Dritteln einer Sekunde mehr.",
    },
    map: {
      title: "MAP-Modelle",
      words:
        "Dynamische Gaußprozess-Modelle mit einem besten Wert für jeden latenten Zustand (Maximum a posteriori) statt einer Verteilung. Sie behalten alle Bilder und werden darum mit vielen langsam.",
    },
    tmp: {
      title: "zeitliche Bewegungsprimitive",
      words:
        "Ein Modell von Kurven über der Zeit: Die Kurve jedes Gelenks ist eine gewichtete Summe weniger glatter Kurven. Es kennt keinen Zustand, also treibt nichts etwas anderes.",
    },
    dmp: {
      title: "dynamische Bewegungsprimitive",
      words:
        "Eine Feder für jedes Gelenk, die eine gelernte Kraft zu einem Ziel oder um einen Zyklus zieht. Die Kraft ist eine gewichtete Summe von Basen.",
    },
    bases: {
      title: "Basen",
      words:
        "Die Hügel über der Zeit, deren gewichtete Summe die Kraft einer DMP ist. Mehr davon folgen dem Clip genauer.",
    },
    dtw: {
      title: "DTW-MSE",
      words:
        "Wie weit eine Vorhersage vom wirklichen Versuch entfernt ist: der mittlere quadratische Fehler nach dynamischer Zeitanpassung. Die Anpassung verzeiht einer Vorhersage, dass sie etwas zu früh oder zu spät ist.",
    },
    fold: {
      title: "Fold",
      words:
        "Ein zurückgehaltener Versuch, während die Modelle aus den anderen lernen und seine ersten Bilder sehen. Jeder Versuch wird einmal zurückgehalten: Ein Modell hat den Rest, nach dem es beurteilt wird, nicht gesehen.",
    },
    "confusion-rate": {
      title: "Verwechslungsrate",
      words:
        "Wie oft Menschen die Bewegung eines Modells für die natürliche halten. Bei einem Halb kann niemand sie unterscheiden; bei 0 können es alle.",
    },
    "attention-check": {
      title: "Aufmerksamkeitsprobe",
      words:
        "Ein Durchgang mit einer Bewegung, die offensichtlich misslungen ist: Wer hinsieht, sieht es. Wer zu viele davon verfehlt, zählt in der Auswertung nicht.",
    },
    "catch-trial": {
      title: "Kontrolldurchgang",
      words:
        "Zwei natürliche Bewegungen, von denen eine noch nicht gezeigt wurde. Wer die natürlichen nur auswendig kennt, bevorzugt die gezeigte.",
    },
    "ln-k": {
      title: "ln K",
      words:
        "Um wie viel besser ein Maß die Antworten von Menschen vorhersagt als eine Konstante, in Nats je Block von Antworten. Kurve und Konstante werden an Antworten geprüft, an die sie nicht angepasst wurden.",
    },
  },
};
