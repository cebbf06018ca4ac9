import { decimal } from "../../ui/decimal";

/** The mean of the ratios of two errors, and the ends of its interval. */
export type Ratio = readonly [mean: number, low: number, high: number];

const ratio = (numbers: Ratio) => {
  const [mean, low, high] = numbers.map((value) => decimal("en", value, 2));
  return `${mean} times (${low} to ${high})`;
};
const times = (value: number) => decimal("en", value, value < 10 ? 1 : 0);

export const belief = {
  title: "Do we know, or do we believe?",
  text:
    "Two points move. Does one drive the other, and which? The truth is behind a curtain, because a " +
    "program made these movements and knows what it did. Of a recorded walk nobody knows the truth: a model " +
    "can only say what explains the recording. Vote first. Then a model learns from ten noisy curves of each " +
    "point, here and now, and draws the arrow that it believes in.",
  guess: {
    question: "Who drives whom?",
    choices: { ab: "A drives B", ba: "B drives A", none: "Neither" },
  },
  drawing: "Drawing the movements.",
  training: (share: number) => `The model is learning: ${decimal("en", 100 * share, 0)} %.`,
  failed: (why: string) => `The model could not be trained: ${why}`,
  believes: {
    ab: "The model believes that A drives B.",
    ba: "The model believes that B drives A.",
    none: "The model believes that neither drives the other.",
    both: "The model believes that each drives the other.",
  },
  measured: (ab: number, ba: number, limit: number) =>
    `Its α from A to B is ${times(ab)} times that of B itself, from B to A ${times(ba)} times that of A ` +
    `itself. From ${decimal("en", limit, 0)} times on, it counts as no say.`,
  curtain: "Show the truth",
  truth: {
    ab: "The truth: one tenth of each move of B comes from A.",
    ba: "The truth: one tenth of each move of A comes from B.",
    none: "The truth: they have nothing to do with each other.",
  },
  score: (you: number, model: number, rounds: number) =>
    `Right so far: you ${you} of ${rounds}, the model ${model} of ${rounds}.`,
  closing: (uncoupled: Ratio, dmp: Ratio) =>
    `On recorded walks held out a model with couplings, trained as in the papers, has ${ratio(uncoupled)} the error of one without, and ` +
    `${ratio(dmp)} that of a rhythmic DMP, in the mean of ten persons: both undecided.`,
  again: "Another pair",
  modelRow: "the model believes",
  truthRow: "the truth",
  figure: "Two points, A on the left and B on the right, each on a path of its own.",
};
