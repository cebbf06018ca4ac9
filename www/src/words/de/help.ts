import type { HelpWords } from "../en/help";

export const words: HelpWords = {
  title: "Wie das funktioniert",
  close: "Schließen",
  model:
    "Das Modell teilt einen Körper in Teile. Die Posen jedes Teils sind Punkte in einem kleinen latenten Raum, und ein Gang ist eine Schleife darin. Wohin ein Teil als Nächstes geht, sagt jeder Teil aus seinen eigenen letzten Bildern voraus; die Gewichte w sagen, wessen Wort zählt. Das α einer Kopplung ist die Varianz einer solchen Vorhersage: kleines α, großes Gewicht.",
  points:
    "Stützpunkte sind die wenigen Beispiele, die das Modell statt der Daten behält: Posen (Rauten) und kurze Stücke Bewegung (Pfeile). Zeige auf einen, um seine Pose zu sehen, und auf der Zeitleiste die Bilder, für die er spricht.",
  training:
    "Das Training erhöht die untere Schranke der Evidenz oder eine Summe wie sie, mit gewichteten Posen: wie gut das Modell die Clips erklärt, abzüglich der Kosten.",
  method: "Die Methode: Gleichungen, Zeichen, Literatur",
  keysTitle: "Tasten",
  keys: [
    ["Leertaste", "abspielen oder anhalten"],
    ["← →", "ein Bild zurück oder vor"],
    ["0", "alle Kopplungen zurücksetzen"],
    ["Entf", "auf einem Regler: diese Kopplung zurücksetzen"],
    [
      "c",
      "gehalten: schneidet eine Kopplung ab, die des gewählten Reglers oder die stärkste zwischen Teilen, und läuft live",
    ],
    ["f j", "wenn zwei Finger die Füße sind: ein Schritt des linken, des rechten Fußes"],
    ["p", "für einen Projektor: nur das Bild, in großer Schrift; Escape bringt den Rest zurück"],
    ["w a s d", "auf der Bühne: von einer anderen Seite sehen"],
    ["+ −", "auf der Bühne: näher, weiter weg"],
    ["q", "der Link zu diesem Zustand, mit QR-Code"],
    ["?", "diese Hilfe"],
  ],
  about: "Über diese Seite",
  licences: "Lizenzen",
  local: "Was du lädst, bleibt auf deinem Gerät: Alles wird in diesem Browser berechnet.",
  samples:
    "Die Beispiele macht ein Programm dieses Projekts. Das Modell, das am Anfang geht, wurde mit Aufnahmen der CMU (Person 7) trainiert.",
  provenance: (engine, seed, clips, version) =>
    `Das Modell jetzt: trainiert von ${engine} mit Startwert ${seed} mit ${clips || "Clips, die es nicht nennt"}. Diese Seite hat die Version ${version}.`,
};
