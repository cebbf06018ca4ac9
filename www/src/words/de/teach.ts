import { decimal } from "../decimal";
import type { TeachWords } from "../en/teach";

const times = (value: number) => `das ${decimal("de", value, 2)}-Fache`;
const seconds = (value: number) => `${decimal("de", value, 2)} s`;

export const teach: TeachWords = {
  title: "Für die Lehre",
  lead: "Die Kapitel sind Folien, die Seite prüft die Aufgaben, und eine Klasse antwortet mit kurzen Codes.",
  slides: {
    title: "Folien",
    start: "Folien starten",
    keys: {
      turn: ["← →", "die Antwort, dann das nächste Kapitel; ein Presenter tut das auch"],
      hands: ["1 2 3", "zählen eine Hand für diese Antwort, Rücktaste nimmt sie zurück"],
      notes: ["n", "deine Notizen, in einem zweiten Fenster"],
      code: ["q", "QR-Code dessen, was zu sehen ist, auch im Labor"],
      end: ["Esc", "beendet die Folien"],
    },
  },
  plan: {
    title: "Plan",
    length: "Länge der Vorlesung",
    minutes: (count) => `${count} Minuten`,
    columns: ["Minuten", "Tun", "Sagen", "Was schiefgeht"],
    do: {
      exercises: "Aufgaben, zu zweit, im Labor",
      compare: "Modelle vergleichen",
      questions: "Verständnisfragen",
    },
  },
  notes: {
    title: "Notizen",
    blocked:
      "Der Browser hat das Fenster mit den Notizen blockiert. Erlaube dieser Seite Fenster und drücke dann noch einmal n.",
    next: (title) => `Danach: ${title}`,
    say: "Sagen",
    wrong: "Was schiefgeht",
    hands: "Hände",
  },
  steps: {
    computer: {
      say: "Ein Gang folgt veröffentlichten Kurven, der andere wurde daraus gelernt. Die Artikel fragten Menschen dasselbe bei Aufnahmen.",
      wrong: "Die Klasse sucht den Fehler in einem Licht: Frag nach dem ersten Eindruck.",
    },
    arms: {
      say: "Wer recht hat, hängt von der Frage ab: was die Daten erlauben, oder was die gelernten Experten tun.",
      wrong: "Alle sagen „stehen bleiben“: Zeig den zweiten Schnitt, und frag, warum beide recht haben.",
    },
    loop: {
      say: "Viele Winkel, drei Zahlen. Neben der Schleife hat das Modell keine Daten.",
      wrong: "Die Ebene wird als Karte von Orten gelesen: Sie ist eine Karte von Posen.",
    },
    next: {
      say: "Das Modell sagt einen Schritt und seine Varianz voraus; eine Bewegung ist viele Schritte.",
      wrong: "Der Fächer gilt als Fehler: Er ist, was das Modell nicht weiß.",
    },
    points: {
      say: "Das Modell behält wenige Posen statt aller Bilder. Die Schranke sagt, was das kostet.",
      wrong: "Wer am wenigsten braucht, gewinnt, aber der Gang muss weitergehen: Lass die Klasse urteilen.",
    },
    product: {
      say: "Zwei Vorhersagen werden multipliziert; Alpha ist die Varianz, die ein Kreis zeigt. Nur Verhältnisse zählen.",
      wrong: "Das Produkt ist schmaler als beide: Frag warum, bevor du es sagst.",
    },
    push: {
      say: "Die Regeln führen zur Schleife zurück: ein Grenzzyklus. Niemand hat dem Modell den Heimweg beigebracht.",
      wrong: "Die Figur gilt als Körper mit Gewicht: Sie kennt Posen, keine Kräfte.",
    },
    borrow: {
      say: "Teile sind Bausteine: Beine eines Gangs und andere Arme, nie zusammen aufgenommen.",
      wrong: "Die Kombination gilt als Filmschnitt: Sie wird neu berechnet.",
    },
    belief: {
      say: "Hier ist die Wahrheit bekannt. Bei Aufnahmen ist sie es nicht: Dann kann ein Modell nur glauben.",
      wrong: "Ein Training braucht einige Sekunden: Frag so lange nach Gründen.",
    },
    gaussian: {
      say: "Eine Eingabe, eine Ausgabe: Mittelwert, Varianz und Punkte zum Ziehen.",
      wrong: "Das Band gilt als Rauschen der Daten: Fern der Punkte ist es, was niemand weiß.",
    },
    end: {
      say: "Was man weiß, was niemand weiß, und was man machen kann: Lass die Klasse wählen, was sie versucht.",
      wrong: "Niemand fragt etwas: Frag, welches Bild überrascht hat.",
    },
    exercises: {
      say: "Verteile das Blatt oder die QR-Codes. Die Seite sagt, wann eine Aufgabe gelöst ist.",
      wrong: "Eine geänderte Kopplung bleibt: vor der nächsten Aufgabe alles zurücksetzen.",
    },
    compare: {
      say: "Einfache Modelle sehen einen zurückgehaltenen Gang ebenso gut voraus. Das gekoppelte hat Teile, die man abschneiden, schieben und tauschen kann.",
      wrong: "Ein Vergleich dauert Minuten: vor der Pause starten, oder die gespeicherten Ergebnisse zeigen.",
    },
    questions: {
      say: "Zehn Fragen mit Antworten stehen in docs/teaching.md.",
      wrong: "",
    },
  },
  exercises: {
    title: "Aufgaben",
    lead: "Jede öffnet das Labor. Dort misst die Seite die Figur und sagt, wann sie gelöst ist.",
    print: "Blatt drucken",
    try: "Ausprobieren",
    code: "QR-Code",
    number: (number) => `Aufgabe ${number}`,
    why: "Warum?",
    tasks: {
      pace: "Lass die Arme ein eigenes Tempo finden; die Hände schwingen mindestens halb so weit wie gelernt.",
      pose: "Die Beine gehen weiter, die Arme behalten eine Pose.",
      ratio: "Ändere zwei Kopplungen je um den Faktor 2 oder mehr. Die Bewegung bleibt genau wie gelernt.",
      idle: "Ändere eine Kopplung um das Hundertfache oder mehr. Hände und Füße bewegen sich wie zuvor, auf 5 % genau.",
      halt: "Halte den ganzen Körper mit einer geänderten Kopplung an.",
      few: "Trainiere ein Modell der Beispielgänge mit höchstens 6 Punkten für die Dynamik jedes Teils. Es geht weiter.",
    },
    whys: {
      pace: "Welchen Pfeil hast du dünn gemacht, und wer spricht jetzt über die Arme?",
      pose: "Warum schwingen die Arme beim selben Pfeil, wenn die Experten neu bestimmt werden?",
      ratio: "Was haben die beiden Faktoren gemeinsam?",
      idle: "Was sagt das darüber, wer in diesem Gang wen erklärt?",
      halt: "Wessen Vorhersage über den nächsten Schritt ging verloren?",
      few: "Wozu wären die anderen Punkte da gewesen?",
    },
    solved: "Gelöst.",
    notYet: "Noch nicht.",
    measuring: "Wird gemessen.",
    close: "Aufgabe schließen",
    found: {
      parts: (legs, arms) => `Schwung der Füße ${times(legs)} des gelernten, der Hände ${times(arms)}.`,
      pace: (legs, arms) => `Beine ${seconds(legs)}, Arme ${seconds(arms)} für einen Schwung.`,
      inStep: (locking) => `Gleichschritt: ${decimal("de", locking, 2)} von 1.`,
      apart: (millimetres) =>
        `Höchstens ${decimal("de", millimetres, 1)} mm von der gelernten Bewegung entfernt.`,
      factors: (list) => (list ? `Geändert: ${list}.` : "Keine Kopplung ist geändert."),
      model: (points) => `Dieses Modell hat ${points} Punkte für einen Teil.`,
      ownModel: "Trainiere zuerst ein Modell.",
      startModel: "Öffne für diese Aufgabe das Modell, mit dem die Seite beginnt.",
      moves: "Es bewegt sich weiter.",
      stands: "Es bewegt sich nicht weiter.",
    },
  },
  codes: {
    title: "Der Wahrnehmungstest mit einer Klasse",
    text: "Alle beantworten den kurzen Test auf dem eigenen Gerät und nennen einen Code. Füge die Codes, einen in jeder Zeile, unter den Antworten des Tests ein.",
    open: "Den Test öffnen",
  },
  code: {
    title: "Teilen",
    copy: "Link kopieren",
    copied: "Kopiert.",
    notCopied: "Der Browser erlaubt es nicht: Kopiere von Hand.",
    close: "Schließen",
    local: "Diese Adresse gilt nur auf diesem Gerät. Lege die Seite für eine Klasse auf einen Webspace.",
  },
};
