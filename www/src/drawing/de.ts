import type { DrawingWords } from "./en";

export const words: DrawingWords = {
  hands: ["links", "rechts"],
  pad: (hand) =>
    `Feld der Hand ${hand}: Zeichne hier. Mit der Tastatur: Pfeiltasten zeichnen, die Eingabetaste lässt los.`,
  invite: [
    "Zeichne eine Schleife, ein paar Mal herum. Lass los.",
    "Eine zweite Hand? Zeichne hier, während die erste weitermacht.",
  ],
  title: "Deine Hand, für immer",
  text: "Zeichne eine Schleife, eine Acht, einen Stern, einen Buchstaben. Ein kleines Modell lernt, wie dein Stift von Moment zu Moment weitergeht. Bei zwei Händen ist jede Hand ein Teil, und die Kopplungen sagen, wie stark jede die andere treibt.",
  example: "Zeig es mir",
  exampleMeaning: "Zeichnet eine Acht und einen Kreis nach einer Formel",
  tooLittle: "Das war zu wenig: Zeichne eine Linie, die länger dauert als ein Moment, und keinen Punkt.",
  badLink:
    "Im Link ist keine Zeichnung, die sich lesen lässt: Vielleicht ist er abgeschnitten. Zeichne, oder bitte noch einmal um den Link.",
  says: "Eine Zeile zum Mitschicken",
  send: "Senden",
  sendMeaning:
    "Ein Link, und sein Code, wenn er nicht zu lang ist, mit dieser Zeichnung und deiner Zeile. Nichts wird gesendet, bevor du es sendest.",
  dare: {
    task: "Halte eine Hand mit einem Pfeil an. Die andere muss weiterzeichnen.",
    met: "Geschafft: Ein Pfeil hat eine Hand angehalten, und die andere zeichnet weiter.",
  },
  learning: "Das Modell lernt deine Zeichnung …",
  goesOn: "Das Modell zeichnet: Es macht weiter wie deine Hand.",
  once: "Du hast es einmal gezeichnet, darum wurde es für das Modell wiederholt. Es macht weiter wie deine Hand.",
  lost: (hand) =>
    `Die Hand ${hand} macht nicht so weiter, wie du gezeichnet hast. Zeichne ein paar Mal herum, ohne Pause und etwas langsamer.`,
  paced: (percent) => `Die zuletzt gezeichnete Hand hat jetzt das Tempo der anderen, um ${percent} % anders.`,
  apart:
    "Deine Hände haben verschiedene Tempi, da ist keine Kopplung zu lernen. Zeichne eine noch einmal, im Takt der anderen.",
  back: (hand) => `${hand} ¼ Runde zurück`,
  backMeaning: "Setzt diese Hand um eine viertel Runde zurück: Wartet die andere auf sie?",
  again: "Leeren",
  lead: {
    one: "Eine Hand, eine latente Schleife mit ihren Stützpunkten. Zeichne mit der zweiten Hand, und kopple beide.",
    two: "Setz eine Hand zurück. Schwäche beide Pfeile zwischen den Händen: Laufen sie auseinander? Verstärke einen: Zieht eine die andere mit?",
  },
  saveDrawing: "Zeichnung, CSV",
  saveDrawingMeaning: "So wie das Modell sie lernte; öffnet sich in Zeitreihen und im Terminal",
  saveModel: "Modell, JSON",
  saveModelMeaning: "Öffnet sich in Zeitreihen und im Terminal",
};
