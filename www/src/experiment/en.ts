/** The view Who drives whom?: the synthetic experiment. */
export const words = {
  title: "Who drives whom?",
  setup: "The experiment",
  part: (place: number) => `Part ${place}`,
  train: "Train",
  training: "Training",
  cancel: "Cancel",
  cancelMeaning: "Stops here and keeps the best so far",
  trained: "This seed was trained to the end; it would find the same again",
  stopping: "Stopping",
  settingUp: "Setting up",
  iteration: (iteration: number) => `Iteration ${iteration}`,
  seedsDone: (over: number, all: number) => `${over} of ${all} seeds done`,
  failed: (why: string) => `Training failed: ${why}`,
  seedDecides: "The seed decides the data and the training.",
  share: (per100: number) => `Training, ${per100} per cent done`,
  ended: "Training ended.",
  seed: "Seed",
  driving: "Part 1 drives part 2",
  drivingHint: "Untick it for the control: two systems that have nothing to do with each other.",
  points: "Inducing points",
  pointsHint: "Of every function. Four: the other model of the paper's figure 3.",
  ten: (driving: boolean) => `Train seeds 0 to 9${driving ? "" : " without driving"}`,
  source:
    "The experiment is that of Velychko et al. (2018), section 5.1. Their draws are not known; these are ours.",
  notMade: (why: string) => `The experiment could not be made: ${why}`,
  tryAgain: "Try again",
  riddle: {
    give: "Give me a riddle",
    giveMeaning: "An experiment whose truth stays behind a curtain",
    question: "Does part 1 drive part 2? Look at the curves of both, and vote. Then a model learns.",
    yes: "Yes",
    no: "No",
    voted: (yes: boolean) => `You say ${yes ? "yes" : "no"}.`,
    read: "What do you read in the α of step 3?",
    curtain: "Show the truth",
    none: "No riddle: choose a seed",
    truth: (driving: boolean, right: boolean) =>
      `The truth: ${driving ? "Part 1 drives part 2." : "Neither drives the other."} You were ${right ? "right" : "wrong"}.`,
  },
  made: {
    title: "What was made",
    hidden:
      "Two systems, each a point that moves in the plane. Whether part 1 drives part 2 is behind a curtain, and so are the points: their paths would tell.",
    points: (frames: number) => `Two systems, each a point that moves in the plane for ${frames} frames.`,
    driven:
      "Part 1 follows a rule of its own. Part 2 follows its own rule too, but one tenth of each move comes from part 1.",
    control: "Each follows a rule of its own. This is the control: part 1 has no share in part 2.",
    rules: "The rules are drawn at random, so that the points go round, each at its own rate.",
  },
  seen: {
    title: "What the model sees",
    text: (frames: number) =>
      `Not the points: only ten noisy curves of each part, made from its point by functions that are drawn at random too. Nobody tells it who drives whom. The first ${frames} frames:`,
  },
  found: {
    title: "What training finds",
    colours:
      "Grey: the true points. Coloured: the learned ones. A model finds its latents only up to stretching, turning and shifting, so they are laid over the true ones by least squares.",
    alpha:
      "A small α is a large influence; the weights w into a part sum to 1. They need not be the 0.1 and 0.9 of step 1: a larger function makes up for a smaller weight.",
    largest: (alpha: number) => `No α can be larger than ${alpha}.`,
    noise: (mse: number) => `The noise alone makes an MSE of ${mse}.`,
  },
  inside: {
    title: "Inside the model",
    text: (points: number) =>
      `Each function keeps ${points} inducing points in place of all frames. Before training the latents are a first guess, the two largest principal components of the smoothed curves, and the points lie on them. Training moves both.`,
    before: "before training",
    after: "after training",
    press: "Press Train.",
    learned: "learned latents",
    path: "mean path: the model goes on alone from its first two states",
    dynamics: "dynamics inducing point: two states, the later one filled",
    poses: "pose inducing point",
    curves:
      "Lower row: three of the ten curves of the data in grey, and those of the mean path in colour. As in figure 3, E to H, of the paper.",
    control:
      "Train with four inducing points, too: then the mean path mostly does not go round as the data do before training, and does after it. With ten it mostly does from the start, and the curves fit better.",
    plane: (part: number, when: string) =>
      `Part ${part}, ${when}: inducing points, latents and mean path in the plane, and below three curves over time`,
    save: "Save the model",
    open: "Open in Time series",
    file: "A model of a table with 20 columns: rollouts, couplings and the terminal program take it as any other.",
  },
  others: {
    title: "Try it yourself",
    text: "One seed proves little. Try others, and untick driving: then α from 1 to 2 must become large. It does not always work: docs/synthetic.md in the project says how often it did.",
    means: (much: number, alike: number) =>
      `Found means: α from 2 to 1 is at least ${much} times α from 1 to 1, and α from 1 to 2 within a factor of ${alike} of α from 2 to 2; without driving it is at least ${much} times as large.`,
  },
  pictures: {
    true: (part: number) => `Part ${part}: the true latents, a path in the plane`,
    learned: (part: number, explained: string) =>
      `Part ${part}: the learned latents over the true ones, of which they explain ${explained}`,
    explained: (share: string) => `${share} explained`,
    curves: (part: number) => `Part ${part}: ten noisy curves over time`,
  },
  couplings: { label: "The learned couplings: rows predict columns", predicts: "predicts" },
  fit: {
    label: "How well the model explains the data",
    start: "Start",
    end: "End",
    now: "Now",
    bound: "Bound",
    boundMeaning: "The evidence lower bound, in nats: the higher, the better",
    mseMeaning: "Mean squared error of a rollout of all frames, after dynamic time warping of each part",
  },
  verdict: {
    begins: "Training begins.",
    press: "Press Train: the couplings that it learns appear here, and what they say about who drives whom.",
    stopped: (iterations: string) => `Stopped after ${iterations} iterations`,
    soFar: (iterations: string) => `So far, after ${iterations} iterations`,
    missed: "Missed: not all that the couplings say is true.",
    driven: "Found: part 1 drives part 2, and part 2 does not drive part 1.",
    neither: "Found: neither part drives the other.",
    ratio: (source: number, target: number, ratio: string) =>
      `α from ${source} to ${target} is ${ratio} times α from ${target} to ${target}:`,
    nothing: (source: number, target: number) =>
      `part ${source} counts for nothing in part ${target}. That is true.`,
    seems: (source: number, target: number, much: number) =>
      `part ${source} seems to have a say in part ${target}, which it has not; ${much} times or more would say so.`,
    say: "part 1 has a say in part 2. That is true.",
    tooSmall: (alike: number) => `too small a say of part 1 in part 2; up to ${alike} times counts as found.`,
    tooLarge: "part 1 seems to have more say in part 2 than part 2 itself, which is not so.",
    tally(found: number, seeds: number, driving: boolean): string {
      const count = `${found} of ${seeds} ${seeds === 1 ? "seed" : "seeds"}`;
      return driving ? `Found with ${count}.` : `Without driving, found with ${count}.`;
    },
    notCounted: (stopped: number) => `${stopped} stopped early, not counted.`,
  },
  runs: {
    label: "What each seed found",
    progress: (seed: number) => `Training of seed ${seed}`,
    look: "Look at this one",
    lookAt: (seed: number, driving: boolean) => `Look at seed ${seed}${driving ? "" : " without driving"}`,
    to: "to",
    yes: "yes",
    no: "no",
    waiting: "waiting",
    failed: "failed",
    stopped: "stopped early",
    heads: {
      seed: "Seed",
      driving: "1 drives 2",
      drivingMeaning: "Whether part 1 drives part 2",
      found: "Found",
      back: "α from 2 to 1, in units of α from 1 to 1",
      forth: "α from 1 to 2, in units of α from 2 to 2",
      bound: "Bound",
      mse: "Mean squared error of the rollout",
      explained: "Latents explained",
      explainedMeaning: "Share of the true latents of part 1 and of part 2 that the learned ones explain",
      iterations: "Iterations",
    },
  },
};

export type ExperimentWords = typeof words;
