/** The latent plots and their layers. A [text|term] in brackets is a term with an explanation. */
export const loops = {
  title: "[Latent spaces|latent-space]",
  about:
    "A loop is the path of a [rollout|rollout] through the latent space of a part, its [movement primitive|movement-primitive]. An arrow is a [coupling|coupling], as thick as its [weight|w]; a small [α|alpha] is a large weight. What couplings do is [measured|measured] on the body.",
  plot: "Plot",
  layers: "Show in the plots",
  pose: { label: "poses", meaning: "Pose inducing points: poses that the pose map is pinned to" },
  dynamics: { label: "dynamics", meaning: "Dynamics inducing points: a history in, its prediction out" },
  between: {
    label: "couplings",
    meaning:
      "Dynamics inducing points of the couplings between parts: dots are histories that predict another part, triangles are predictions by another part",
  },
  aboutPoints: "What are inducing points?",
  predictions: {
    label: "predictions",
    meaning:
      "What each part predicts about the next state, one standard deviation wide, in its colour; in black their product, to which the step goes. Dashed: hardly heard",
  },
  aboutPredictions: "What do the predictions show?",
  futures: { label: "futures", meaning: "Five motions that the model could make as well, drawn at random" },
  uncertainty: {
    label: "uncertainty",
    meaning: "Where the state is, as far as one Gaussian can say",
  },
  certainty: {
    label: "where the model is sure",
    meaning: "Colour: poses that the model is sure about. Arrows: where its dynamics lead. In the 2-D plots",
  },
  plotOf: (part: string) => `Latent space of ${part}`,
  turn: "Drag, or use the arrow keys, to turn it",
  dynamicsPoint: (number: number, source: string, target: string | null) =>
    `Dynamics inducing point ${number} of ${source}${target === null ? "" : ` about ${target}`}`,
  posePoint: (number: number, part: string) => `Pose inducing point ${number} of ${part}`,
  fiveFutures: (first: number, last: number) => `[Five futures|future], seeds ${first} to ${last}`,
  fiveOthers: "Five others",
  gaussian: (loading: boolean) =>
    `Grey: [what a Gaussian knows|moment-matching], ±1 and ±2 σ${loading ? " (loading)" : ""}`,
  push: {
    state: (part: string) => `State of ${part} now. Drag it, or use the arrow keys, to push this part.`,
    drag: (part: string) => `Drag to push ${part}`,
  },
  none: {
    futures: "No futures",
    uncertainty: "No uncertainty",
    certainty: "No picture of where the model is sure",
  },
};

export type LoopsWords = typeof loops;
