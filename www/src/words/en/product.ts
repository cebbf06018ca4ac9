export const product = {
  title: "Two guesses, one step",
  text:
    "Two experts guess the arms’ next step: the arms and the legs. A guess is a bell: its middle, and a circle whose " +
    "size is its variance, alpha. The two bells are multiplied: the step lies between, nearer to the smaller circle. " +
    "The legs’ guess lies far off because both learned as a team: it only has to pull the step the right way. " +
    "Pull at a circle.",
  guess: {
    question: "We double both alphas. How will the arms move?",
    choices: {
      more: "They swing further",
      same: "Exactly as before",
      less: "They swing less",
    },
  },
  plane: "The latent space of the arms: two guesses and their product",
  radius: {
    arms: (alpha: string) => `Circle of the arms, alpha ${alpha}: arrow keys change it`,
    legs: (alpha: string) => `Circle of the legs, alpha ${alpha}: arrow keys change it`,
  },
  sources: { arms: "arms", legs: "legs" },
  row: (name: string, alpha: string, percent: string) => `${name}: alpha ${alpha}, counts ${percent} %`,
  hint: "Pull at the dots beside the circles.",
  learned: "As learned",
  twice: "Double both",
  doubled: (millimetres: string, wider: string) =>
    `In ten seconds, the largest distance of a joint from its old path is ${millimetres} mm. Only the circle of the step is ` +
    `${wider} times as wide: the ratio of the alphas says where, their size how exactly.`,
  equation: "The weights w depend only on the ratios of the alphas. The variance of the product does not.",
};
