export const points = {
  title: "A few poses are enough",
  text:
    "The model does not keep the recordings. It keeps a few poses and a few steps, the inducing points. What " +
    "it learned is smooth, so it can compute everything between these points. Here are those of the legs. What " +
    "happens when we take some away? For each choice the page solves the model again from the same data, and " +
    "measures the walk.",
  guess: {
    question: (poses: number, steps: number) =>
      `The legs have ${poses} poses and ${steps} steps. How many of the ${poses + steps} does the walk need?`,
    choices: { most: "Nearly all", half: "About half", few: "Ten or fewer" },
  },
  plane: "The latent space of the legs with their inducing points",
  legend: "◆ poses   ➝ steps",
  point: {
    poses: (number: number) => `Pose ${number}`,
    steps: (number: number) => `Step ${number}`,
  },
  found: (count: number, nats: string, centimetres: string) =>
    `${count} points: joints ${centimetres} cm off, the bound ${nats} nats less.`,
  walks: "The walk goes on.",
  stumbled: "The walk stumbles.",
  enough: (enough: number, all: number, centimetres: string) =>
    `${enough} of ${all} points are enough: on average the joints are ${centimetres} cm off. With one less the walk ` +
    "stumbles. Each time the page took away the point without which the bound falls least.",
  hint: (fewest: number | null) =>
    fewest === null
      ? "Press points to take them away or back. Fewest wins."
      : `Press points to take them away or back. Your record: ${fewest}.`,
  waiting: "The page loads the program that solves the model anew.",
  removing: "One point after the other goes.",
  all: "All points",
  pair: (many: number, few: number) => `${many} beside ${few} points`,
  column: (count: number) => `${count} points`,
  chart: {
    bound: "bound",
    error: "error of the walk",
    label: "Bound and error of the walk, from all points on the left to two on the right",
  },
  equation: "The posterior of the inducing outputs u, solved anew for the points that are left.",
};
