import { decimal } from "../../ui/decimal";
import type { TeachWords } from "../en/teach";

const times = (value: number) => `das ${decimal("de", value, 2)}-Fache`;
const seconds = (value: number) => `${decimal("de", value, 2)} s`;

export const words: TeachWords = {
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
    answer: "Antwort",
    asked: "Was sie fragen könnten",
    minutes: (from, to) => `Minuten ${from}–${to}`,
    hands: "Hände",
  },
  steps: {
    hand: {
      say: "Du hast gezeichnet, und etwas anderes macht weiter: eine Regel für den nächsten Moment, gelernt in wenigen Sekunden. Das ist ein Bewegungsprimitiv.",
      wrong: "Nur ein Punkt oder eine halbe Runde: Zeichne drei Runden ohne Pause.",
      asked: [
        [
          "Wiederholt es, was ich gezeichnet habe?",
          "Nein: Es merkt sich wenige Punkte einer Regel und macht jeden Schritt aus den zwei davor. So kann es immer weitergehen, und irren.",
        ],
        [
          "Warum eine Schleife?",
          "Was zu sich zurückkehrt, ist eine Schleife. Das Modell merkt sich einen Moment davon in zwei Zahlen.",
        ],
      ],
    },
    arms: {
      say: "Wer recht hat, hängt von der Frage ab: was die Daten erlauben, oder was die gelernten Experten tun.",
      wrong: "Alle sagen „Anhalten“: Zeig den zweiten Schnitt, und frag, warum beide recht haben.",
      answer:
        "In diesem Modell, das dafür gewählt wurde: Neu bestimmt finden die Arme ein eigenes Tempo. Wie gelernt halten sie an.",
      asked: [
        [
          "Was von beidem ist richtig?",
          "Beides: Das eine fragt, was die Clips ohne die Beine erlauben, das andere, was die gelernte Regel allein tut.",
        ],
        [
          "Was ist der Faden wirklich?",
          "Eine Zahl, Alpha von den Beinen zu den Armen: die Varianz dessen, was die Beine über die Arme vermuten.",
        ],
      ],
    },
    loop: {
      say: "Viele Winkel, drei Zahlen. Neben der Schleife hat das Modell keine Daten.",
      wrong: "Die Ebene wird als Karte von Orten gelesen: Sie ist eine Karte von Posen.",
      answer:
        "Sie verblasst: Neben der Schleife wächst der Zweifel, weit weg bis zu dem eines Modells ohne Daten.",
      asked: [
        [
          "Warum drei Zahlen?",
          "Beim Gehen bewegen sich die Winkel gemeinsam, also halten wenige Zahlen eine Pose fest. Wie viele, ist im Labor eine Einstellung: Versuche zwei.",
        ],
        [
          "Schließt sich die Schleife genau?",
          "Fast: Jeder Schritt ist eine Vermutung, und sie führen zurück.",
        ],
      ],
    },
    next: {
      say: "Das Modell sagt einen Schritt und seine Varianz voraus; eine Bewegung ist viele Schritte.",
      wrong: "Der Fächer gilt als Fehler: Er ist, was das Modell nicht weiß.",
      answer:
        "Das hängt von der Nadel ab. Das Mittel der Zukünfte ist die beste Vermutung, einzelne weichen ab.",
      asked: [
        [
          "Warum ist der Kreis klein und der Fächer weit?",
          "Der Kreis ist ein Schritt. Die Unsicherheit wächst von Schritt zu Schritt.",
        ],
        [
          "Warum kommt der Weg zur Schleife zurück?",
          "Die aufgenommenen Schritte liegen an ihr entlang, und die Vermutungen führen zu ihnen.",
        ],
      ],
    },
    points: {
      say: "Das Modell behält wenige Posen statt aller Bilder. Die Schranke sagt, was das kostet.",
      wrong: "Wer am wenigsten braucht, gewinnt, aber der Gang muss weitergehen: Lass die Klasse urteilen.",
      answer: "Auf dem Weg der Seite etwa die Hälfte, 12 von 24. Gut gewählt können sechs gehen.",
      asked: [
        [
          "Warum nicht alle Bilder behalten?",
          "Die Arbeit wächst mit den Punkten, und was dazwischen liegt, lässt sich berechnen.",
        ],
        [
          "Wo liegen die Punkte?",
          "Wo das Training sie hinlegt: Sie wandern, bis die Schranke nicht mehr steigt.",
        ],
      ],
    },
    product: {
      say: "Zwei Vorhersagen werden multipliziert; Alpha ist die Varianz, die ein Kreis zeigt. Nur Verhältnisse zählen.",
      wrong: "Das Produkt ist schmaler als beide: Frag warum, bevor du es sagst.",
      answer: "Genau wie vorher: Nur Verhältnisse der Alphas bewegen den Schritt.",
      asked: [
        [
          "Warum vermuten die Beine dort?",
          "Beide Experten lernten zusammen. Der Teil der Beine muss das Produkt nur richtig ziehen.",
        ],
        [
          "Multipliziert oder gemittelt?",
          "Multipliziert. Sind die Glocken in alle Richtungen gleich breit, ist das Mittel des Produkts ein gewichtetes Mittel, und seine Varianz ist kleiner als jede.",
        ],
      ],
    },
    push: {
      say: "Die Regeln führen zur Schleife zurück: ein Grenzzyklus. Niemand hat dem Modell den Heimweg beigebracht.",
      wrong: "Die Figur gilt als Körper mit Gewicht: Sie kennt Posen, keine Kräfte.",
      answer: "Er kommt zurück; die Karte sagt, nach wie vielen Sekunden.",
      asked: [
        [
          "Hat ihm das jemand beigebracht?",
          "Nein. Die aufgenommenen Schritte liegen um die Schleife, und die Regeln dieses Modells führen zu ihr zurück. Andere Modelle kommen zur Ruhe.",
        ],
        ["Könnte er fallen?", "Nein: Das Modell kennt Posen, kein Gewicht und keinen Boden."],
      ],
    },
    borrow: {
      say: "Teile sind Bausteine: Beine eines Gangs und andere Arme, nie zusammen aufgenommen.",
      wrong: "Die Kombination gilt als Filmschnitt: Sie wird neu berechnet.",
      answer: "Die Arme machen ihre eigene Bewegung.",
      asked: [
        [
          "Ist das ein Filmschnitt?",
          "Nein: Jede Pose wird aus den letzten berechnet. Hier hören die neuen Nachbarn kaum aufeinander: Sie trafen sich nie.",
        ],
        [
          "Geht jede Kombination?",
          "Nein. Manche Teile kommen zur Ruhe, weil sie nie lernten, einander zu treiben.",
        ],
      ],
    },
    belief: {
      say: "Hier ist die Wahrheit bekannt. Bei Aufnahmen ist sie es nicht: Dann kann ein Modell nur glauben.",
      wrong: "Ein Training braucht einige Sekunden: Frag so lange nach Gründen.",
      answer:
        "Der Vorhang sagt es. Wie oft ein Modell recht hat, zählt docs/synthetic.md, nach einer strengeren Regel als diese Karte.",
      asked: [
        [
          "Warum nicht am Gang prüfen?",
          "Dort kennt niemand die Wahrheit: Ein Modell sagt nur, was die Aufnahme erklärt.",
        ],
        ["Wie sieht „keiner“ aus?", "Beide Alphas zwischen den Punkten sind groß: kein Einfluss."],
      ],
    },
    gaussian: {
      say: "Eine Eingabe, eine Ausgabe: Mittelwert, Varianz und Punkte zum Ziehen.",
      wrong: "Das Band gilt als Rauschen der Daten: Fern der Punkte ist es, was niemand weiß.",
      answer: "Null, mit einem breiten Band: Der Prozess sagt, dass er es nicht weiß.",
      asked: [
        [
          "Warum null?",
          "Das ist der Mittelwert, der vor allen Daten gewählt wurde. Im Modell eines Gangs ist null das Mittel aller Posen.",
        ],
        ["Warum ist das Band an den Punkten schmal?", "Ein Punkt sagt den Wert dort, bis auf Rauschen."],
      ],
    },
    end: {
      say: "Die Karte fasst Regeln, Schleifen und Kopplungen zusammen. Lass die Klasse wählen, was sie im Labor versucht.",
      wrong: "Niemand fragt etwas: Frag, welches Bild überrascht hat.",
      asked: [
        [
          "Was soll ich zuerst versuchen?",
          "Zieh im Labor Beine → Arme nach links, und sieh die Schleife der Arme.",
        ],
      ],
    },
    exercises: {
      say: "Verteile das Blatt oder die QR-Codes. Die Seite sagt, wann eine Aufgabe gelöst ist.",
      wrong: "Eine geänderte Kopplung bleibt: vor der nächsten Aufgabe alles zurücksetzen.",
    },
    compare: {
      say: "Dass das gekoppelte Modell, trainiert wie in den Artikeln, einen zurückgehaltenen Gang besser voraussieht als zwei einfache, das TMP und das rhythmische DMP, fanden wir nicht. Es hat Teile, die man abschneiden, schieben und tauschen kann.",
      wrong: "Ein Vergleich dauert Minuten: vor der Pause starten, oder die gespeicherten Ergebnisse zeigen.",
    },
    questions: {
      say: "Zehn Fragen: Wer zugehört hat, beantwortet sie aus dem, was zu sehen war.",
      wrong: "",
      asked: [
        [
          "Was lernt das Modell aus einer Aufnahme: Posen oder Regeln für die nächste Pose?",
          "Regeln: Aus den letzten Zuständen eines Teils sagt es den nächsten voraus. Die Bewegung auf der Seite wurde nie aufgenommen.",
        ],
        [
          "Ein Körper hat viele Winkel. Warum genügen drei Zahlen je Teil zum Gehen?",
          "Beim Gehen bewegen sich die Winkel gemeinsam: Die Zustände liegen nah an einer geschlossenen Kurve in einem Raum weniger Dimensionen.",
        ],
        [
          "Was geschieht mit der Figur, wenn ihr Zustand die gelernte Kurve verlässt, und warum?",
          "Das Modell hat diese Punkte nie gesehen: Sein Zweifel wächst, weit weg bis zu dem eines Modells ohne Daten, und die Figur verblasst.",
        ],
        [
          "Ein Gaußprozess gibt zu jeder Vorhersage zweierlei. Was?",
          "Einen Mittelwert und eine Varianz: den nächsten Zustand, und wie sicher das Modell ist.",
        ],
        [
          "Das Modell ist einen Schritt lang. Wie macht es eine Bewegung von zehn Sekunden?",
          "Jeder vorhergesagte Zustand ist der Eingang der nächsten Vorhersage: ein Rollout.",
        ],
        [
          "Was ist ein Stützpunkt, und warum genügen wenige?",
          "Ein Punkt, an dem die Funktion bekannt ist. Das Modell behält sie statt aller Bilder: Eine glatte Funktion braucht nicht mehr.",
        ],
        [
          "Zwei Teile sagen den nächsten Zustand der Arme voraus. Wie wird daraus eine Vorhersage?",
          "Sie werden multipliziert: Das Mittel liegt dazwischen, näher bei der kleineren Varianz Alpha.",
        ],
        [
          "Was ist die Kopplung Alpha von den Beinen zu den Armen, und was tut ein großes Alpha?",
          "Eine Varianz: Je größer sie ist, desto weniger hören die Arme auf die Beine.",
        ],
        [
          "Halten die Arme ohne die Kopplung an?",
          "Beide Antworten sind richtig für je eine Frage, in diesem Modell, das dafür gewählt wurde: Neu bestimmt schwingen sie in eigenem Tempo weiter, wie gelernt behalten sie eine Pose.",
        ],
        [
          "Das Modell zeigt, dass es eine Kopplung gibt. Zeigt das, dass die Beine die Arme des Menschen treiben?",
          "Nein. Es zeigt, was die Aufnahmen erklärt. Daten mit bekanntem Treiber zeigen, wie oft das Modell ihn findet.",
        ],
      ],
    },
  },
  exercises: {
    title: "Aufgaben",
    lead: "Jede öffnet eine Seite, die die Bewegung misst und sagt, wann sie gelöst ist.",
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
      halt: "Lass den ganzen Körper mit einer geänderten Kopplung in einer Pose bleiben.",
      few: "Trainiere ein Modell der Beispielgänge mit höchstens 6 Punkten für die Dynamik jedes Teils. Es geht weiter.",
      hands:
        "Zeichne zwei Kreise in zwei Tempi, mit jeder Hand einen. Halte eine Hand mit einem Pfeil an; die andere zeichnet weiter.",
    },
    solutions: {
      pace: "neu bestimmt, Beine → Arme ganz nach links.",
      pose: "wie gelernt, Beine → Arme ganz nach links.",
      ratio:
        "wie gelernt, Beine → Arme und Arme → Arme um gleich viele Tasten: Nur das Verhältnis der Kopplungen in einen Teil zählt.",
      idle: "neu bestimmt, Arme → Beine ganz nach links: Die eigene Vergangenheit erklärt die Beine.",
      halt: "wie gelernt, Beine → Beine ganz nach links: Dann hören die Beine nur auf die Arme, die nichts über Beine gelernt haben.",
      few: "Der Link setzt 6 Punkte; drück Trainieren.",
      hands:
        "wie gelernt, links → links ganz nach links: Die linke Hand hört dann nur die rechte, die nichts über sie gelernt hat.",
    },
    whys: {
      pace: "Welchen Pfeil hast du dünn gemacht, und wer spricht jetzt über die Arme?",
      pose: "Warum schwingen die Arme beim selben Pfeil, wenn die Experten neu bestimmt werden?",
      ratio: "Was haben die beiden Faktoren gemeinsam?",
      idle: "Was sagt das darüber, wer in diesem Gang wen erklärt?",
      halt: "Wessen Vorhersage über den nächsten Schritt ging verloren?",
      few: "Wozu wären die anderen Punkte da gewesen?",
      hands: "Warum zeichnet die andere Hand weiter?",
    },
    dares: {
      title: "Eine Herausforderung",
      none: "keine Herausforderung",
      tasks: {
        pose: "Halte die Arme mit einem Pfeil an. Die Beine müssen weitergehen.",
        pace: "Lass die Arme in einem eigenen Tempo schwingen.",
        hand: "Halte eine Hand mit einem Pfeil an. Die andere muss weiterzeichnen.",
      },
      line: "Eine Zeile zum Mitschicken",
      met: "Du hast es geschafft.",
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
      reading: "Neu bestimmt ändern sich auch die Regeln: Wähle „wie gelernt“.",
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
