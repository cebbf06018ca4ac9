export const gaussian = {
  title: "What is a Gaussian process?",
  text:
    "A Gaussian process guesses a curve from points. Near a point it is sure; far from all points it is not, and " +
    "says so: the band is two standard deviations wide on each side. Drag the points and watch the curve. A few " +
    "inducing points can stand for all of them. And where one asks may be uncertain, too.",
  guess: {
    question: "What does it say at the dotted line, far from all points?",
    choices: {
      on: "The curve goes on as before",
      prior: "Zero, and a wide band",
      nothing: "Nothing",
    },
  },
  plane: "A Gaussian process of one input",
  point: (number: number) => `Point ${number}: arrow keys move it`,
  inducing: (number: number) => `Inducing point ${number}: arrow keys move it`,
  input: "The input: arrow keys move it",
  hint: "Drag the points.",
  exact: "All points",
  sparse: (count: number) => `${count} inducing points`,
  spread: "Uncertain input",
  reveal: {
    answer: (mean: string, deviation: string, near: string) =>
      `There: ${mean} ± ${deviation} (2 σ), as before it saw a point. At the first point: ± ${near}.`,
    input: (mean: string, deviation: string) => `At the orange input: ${mean} ± ${deviation}.`,
  },
  equation: "The kernel k says how alike the curve is at two inputs.",
};
