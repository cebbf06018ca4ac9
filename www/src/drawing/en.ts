/** The view Draw. */
export const words = {
  hands: ["left", "right"],
  pad: (hand: string) =>
    `Pad of the ${hand} hand: draw here. With the keyboard: arrow keys draw, Enter lets go.`,
  invite: ["Draw a loop, a few times round. Let go.", "A second hand? Draw here while the first goes on."],
  title: "Your hand, for ever",
  text: "Draw a loop, an eight, a star, a letter. A small model learns how your pen goes on from moment to moment. With two hands each hand is a part, and the couplings say how strongly each drives the other.",
  example: "Show me",
  exampleMeaning: "Draws an eight and a circle by a formula",
  tooLittle: "That was too little: draw a line that is longer than a moment, and not a dot.",
  badLink: "The link has no drawing that can be read: it may have been cut. Draw, or ask for the link again.",
  says: "A line to send along",
  send: "Send",
  sendMeaning:
    "A link, and its code if it is not too long, with this drawing and your line. Nothing is sent before you send it.",
  dare: {
    task: "Stop one hand with one arrow. The other hand must draw on.",
    met: "Done: one arrow stopped one hand, and the other draws on.",
  },
  learning: "The model learns your drawing …",
  goesOn: "The model draws: it goes on as your hand did.",
  once: "You drew it once, so it was repeated for the model. It goes on as your hand did.",
  lost: (hand: string) =>
    `The ${hand} hand does not go on as you drew it. Draw it a few times round, without a rest, and a little slower.`,
  paced: (percent: number) => `The hand that you drew last got the tempo of the other, ${percent} % away.`,
  apart:
    "Your hands keep different tempos, so there is no coupling to learn. Draw one again, in time with the other.",
  back: (hand: string) => `${hand} ¼ round back`,
  backMeaning: "Sets this hand back by a quarter of a round: does the other hand wait for it?",
  again: "Clear",
  lead: {
    one: "One hand, one loop of latents with its inducing points. Draw with the second hand, and couple them.",
    two: "Set one hand back. Weaken both arrows between the hands: do they fall apart? Strengthen one: does one hand drag the other?",
  },
  saveDrawing: "Drawing, CSV",
  saveDrawingMeaning: "As the model learned it; opens in Time series and in the terminal",
  saveModel: "Model, JSON",
  saveModelMeaning: "Opens in Time series and in the terminal",
};

export type DrawingWords = typeof words;
