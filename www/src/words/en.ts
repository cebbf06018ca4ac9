// The English words of the page. The other languages have the type of this file, so that the compiler finds a
// missing sentence.
import { arms } from "./en/arms";
import { belief } from "./en/belief";
import { borrow } from "./en/borrow";
import { push } from "./en/push";

/** The frame of the story: what all chapters share. */
const frame = {
  page: "Coupled movement primitives",
  story: "Story",
  lab: "Lab",
  teach: "For teachers",
  views: "Views",
  stage: "Stage",
  chapters: "Chapters",
  place: (chapter: number, count: number) => `${chapter} of ${count}`,
  back: "Previous chapter",
  next: "Next",
  nextChapter: "Next chapter",
  guessed: (choice: string) => `Your guess: ${choice}`,
  hands: (count: number, total: number, choice: string) => `${count} of ${total} said “${choice}”`,
  equation: "The equation",
  openInLab: "Open in the lab",
  loading: "Loading",
  notLoaded: "This part of the page could not be loaded. Is this machine offline?",
  labNotLoaded: "The Lab could not be loaded. Is this machine offline?",
  tryAgain: "Try again",
  noModel: (why: string) => `The model cannot run here: ${why}`,
  dismiss: "Dismiss",
};

const hand = {
  title: "Draw it. It goes on.",
  text:
    "A movement primitive is a small model of one movement. Make one: draw in the box. The model learns here, in " +
    "your browser, how your pen goes on from moment to moment. Then it draws by itself.",
  example: "Show me",
  two: "Draw with two hands",
  again: "Clear",
  learned: (points: number) =>
    `Beside it is what the model keeps in mind: two numbers for each moment, on a loop. ${points} marked points hold its rule for the next step.`,
};

const end = {
  title: "Now it is yours",
  text:
    "What you now know: each part of a body can have a small rule of its own, which leads round a loop. The rule " +
    "says where it is not sure. Rules of two parts are multiplied, and alpha says who counts. So parts can be cut, " +
    "pushed and exchanged.",
};

const gaussian = {
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

const loop = {
  title: "A walk is a loop",
  text:
    "A pose of the legs is a long list of angles. In a walk the angles move together, so the model writes a " +
    "pose as three numbers, a point in a small space. While the body walks, the point runs round a loop, once " +
    "for every two steps. Drag the dot round the loop and the body follows. Around the loop lie points that " +
    "the model has never seen.",
  guess: {
    question: "We pull the dot off the loop. What will the body do?",
    choices: {
      walk: "Take other steps",
      stop: "Stop in its last pose",
      dissolve: "It fades: the model grows unsure",
    },
  },
  dot: "The dot on the loop of the legs: arrow keys left and right move it round, up and down off the loop",
  plane: "The latent space of the legs",
  sizes: (columns: number, latent: number) => `legs: ${columns} numbers become ${latent}`,
  hint: "Drag the dot round the loop.",
  hintOff: "Now drag the dot anywhere. Colour: where the model knows the pose.",
  walk: "Let it walk",
  offLoop: (here: string, loop: string) =>
    `Here the model’s doubt about the pose is ${here} % of its doubt far from all data; on the loop it is at most ` +
    `${loop} %. The legs are drawn as faintly as the model is unsure.`,
  onLoop: (loop: string) =>
    `On the loop the model’s doubt about the pose is at most ${loop} % of its doubt far from all data.`,
  equation: "The pose map g makes a pose y of a point x. Its doubt is the deviation of g at x.",
};

const next = {
  title: "What next?",
  text:
    "The model has learned a rule for the next step: a Gaussian process, as on the card before. From where the point was and where it " +
    "is, the rule says where the point will be: the arrow is its guess, the circle is how sure it is. Guess " +
    "after guess makes a path. Where will the point be ten frames from now? Put a pin there, and then look at " +
    "futures that the model thinks possible.",
  guess: {
    question: "Where will the point be in a third of a second? Move the pin.",
    choices: { pin: "My pin is in place" },
  },
  pin: "The pin: arrow keys move it",
  anywhere: "A start anywhere: arrow keys move it",
  plane: "The latent space of the legs, with the next step",
  hint: "The circle is two standard deviations wide on each side.",
  hintAnywhere: "Now press anywhere: the walk starts there, and the path bends into the loop.",
  again: "Another start",
  away: (deviations: string) => `Your pin is ${deviations} standard deviations from the mean of the futures.`,
  beat: (beaten: number, futures: number) =>
    beaten === 0
      ? `All of the ${futures} futures that the model has drawn are nearer: far off.`
      : `It is nearer than ${beaten} of ${futures} futures that the model has drawn.`,
  back: (seconds: string) => `From there the path came back to the loop after ${seconds} s.`,
  lost: "From there the path did not come back to the loop in four seconds.",
  equation: "The next point of a part is drawn around the guess of the experts f, with the variance α.",
};

const points = {
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
    `${count} points: joints ${centimetres} cm off, fit to the recordings ${nats} nats lower.`,
  walks: "The walk goes on.",
  stumbled: "The walk stumbles.",
  enough: (enough: number, all: number, centimetres: string) =>
    `${enough} of ${all} points are enough: on average the joints are ${centimetres} cm off. The page took away what ` +
    "costs least; one more, and the walk stumbles. Other choices need fewer.",
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
    bound: "fit (bound)",
    error: "error of the walk",
    guess: "your guess",
    label: "Bound and error of the walk, from all points on the left to two on the right",
  },
  equation: "The posterior of the inducing outputs u, solved anew for the points that are left.",
};

const product = {
  title: "Two guesses, one step",
  text:
    "Two experts guess the arms’ next step: the arms and the legs. A guess is a bell: its middle, and a circle whose " +
    "area grows with its variance, alpha. The two bells are multiplied: the step lies between, nearer to the smaller circle. " +
    "The legs’ guess alone would be wrong: both learned together, and only their product has to be right. " +
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

export const words = {
  frame,
  /** The chapters of the story, in their order. */
  chapters: { hand, arms, loop, next, points, product, push, borrow, belief, gaussian, end },
};

export type Words = typeof words;
