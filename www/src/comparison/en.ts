/** The view Compare models. A [text|term] in brackets is a term with an explanation. */
export const words = {
  title: "Compare models",
  setup: "What to compare",
  found: "What came of it",
  compare: "Compare",
  cancel: "Cancel",
  cancelMeaning: "Stops; finished trainings are kept",
  comparing: "Comparing",
  share: (per100: number) => `Comparing, ${per100} per cent done`,
  loadingModels: "Loading the other models",
  cancelling: "Cancelling",
  done: (over: number, all: number) => `${over} of ${all} trainings done`,
  failed: (why: string) => `The comparison failed. ${why}`,
  /** `before`: trainings that were finished before. */
  plan: (open: number, before: number) =>
    `${open} ${open === 1 ? "training" : "trainings"}${before > 0 ? `, ${before} finished before` : ""}.`,
  ofItsOwn: " Other trials, parts or frame rate than below: a comparison of its own.",
  shorter: "Fewer models, trials, seeds or iterations make it shorter.",
  /** The estimate neglects TMPs and DMPs, so a short one is no promise. */
  shortWait: "How long this takes depends on the machine. The time left is shown while it runs.",
  finishedBefore: "All of this was finished before.",
  summary: (done: number, all: number, failed: number, cancelled: boolean) =>
    `${done} of ${all} trainings done${failed > 0 ? `, ${failed} failed` : ""}${cancelled ? "; the others were cancelled." : "."}`,
  notBegun: "You cancelled before it began.",
  opened: (results: number) => `${results} results opened.`,
  running: "A comparison is running: cancel it before opening results.",
  noStudy: (why: string) => `No study was made: ${why}`,
  noModelYet: "No model was trained here yet.",
  studyTitle: "A comparison on this page",
  work: (trainings: number) => `a comparison of ${trainings} ${trainings === 1 ? "training" : "trainings"}`,
  whyNot: {
    twoParts: "The ticked models need two parts or more",
    gettingReady: "Getting ready",
    cannotRun: "The models cannot run in this browser",
    twoClips: "Tick at least two clips: one is held out, the others are trained on",
    noTrial: (trial: number, ticked: number) => `There is no trial ${trial}: ${ticked} clips are ticked`,
    oneModel: "Tick at least one model",
  },
  tooLarge: "This file has more than 200 MB; expected the results of a comparison.",
  openResults: "Open results",
  openResultsMeaning: "Open results (.json) of this page or of the terminal",
  saveResults: "Save results",
  walks: "Ten recorded walks",
  walksMeaning: "All models, ten walks of one person, 30 frames a second",
  makeStudy: "Make a study",
  makeStudyMeaning: "Ask people which movement is the more natural: a study of the movements compared here",
  about:
    "Each trial is [held out in turn|fold]. Every model learns from the others, sees the trial’s first five frames, and predicts the rest.",
  given:
    "All models on ten recorded walks of one person (CMU subject 35), measured before: four of them above, from the sixth frame of a walk. What you compare takes their place.",
  lesson:
    "We did not find that the coupled model foresees a walk better than two simple ones that know that a walk repeats itself: in the mean of ten persons, the error of the vCGPDM, trained as in the papers, is 1.15 times (1.04 to 1.28) that of the TMP, and 1.18 times (0.98 to 1.41) that of the rhythmic DMP. Corrected for ten questions, neither difference is decided. Couplings are for changing a movement.",
  failure: (model: string, trial: number, why: string) => `${model}, trial ${trial} held out: ${why}`,
  models: {
    title: "Models",
    whatIs: "What is [MAP|map], [TMP|tmp], [DMP|dmp]?",
    about: {
      vcgpdm: "The coupled model of this page, trained as in the papers",
      vgpdm: "The same, with the whole body as one part",
      "map-gpdm": "Point latents instead of distributions; slow",
      "map-cgpdm": "The same, with coupled parts; slowest",
      tmp: "Weighted curves over a common phase",
      "dmp-discrete": "A spring pulled towards a goal",
      "dmp-rhythmic": "A spring pulled around a cycle",
    },
  },
  trials: {
    title: "Trials",
    ticked: (ticked: number, all: number) => `${ticked} of ${all} clips ticked`,
    drop: "Drop your own clips (.bvh) anywhere on the page.",
    bottle: {
      about: "Two arms that meet: ten made trials of passing a bottle, in three parts.",
      load: "Pass a bottle",
      found:
        "We found that on the ten trials of passing a bottle three parts predict worse than a TMP, which is a curve over time: 7.59 times its error (4.28 to 10.90). Whether they are worse than the whole body as one part is undecided: 2.64 times its error (0.59 to 5.05).",
      watch: "Watch in the Lab",
    },
  },
  fields: {
    parts: { label: "Parts of the coupled models", hint: "How the coupled models split the body" },
    byHand: (names: string) => `By hand: ${names}`,
    ips: {
      label: "Inducing points",
      hint: "Of every dynamics map and every pose map of the variational models; several to compare",
    },
    bases: {
      label: "DMP bases",
      hint: "Basis functions of every column of the DMPs; several to compare",
    },
    comparedIterations: {
      label: "Iterations at most",
      hint: "Of the optimiser, for every model that has one",
    },
    heldOut: {
      label: "Only trial (0: each)",
      hint: "The trial held out, counted from 1; 0: each in turn",
    },
    growth: {
      label: "Learning time against frames",
      hint: "Trains the vCGPDM and the MAP CGPDM also on fewer trials",
    },
    growthNeeds: "Needs the vCGPDM or the MAP CGPDM, and four trials or more.",
    growthTimes: "Times are taken with all workers busy; the terminal can measure alone.",
    seed: { label: "First seed", hint: "Of everything random" },
    seeds: { label: "Seeds", hint: "How many, from the first on" },
    latent: { label: "Latent dimensions", hint: "Of every part" },
    order: { label: "Frames of history", hint: "The order of the dynamics" },
    framesPerSecond: { label: "Frames a second", hint: "Clips are resampled to this rate" },
    balanced: {
      label: "Balanced MAP models",
      hint: "Their dynamics weigh as much as their many columns (Urtasun, Fleet and Fua 2006)",
    },
  },
  beside: {
    noGraphics:
      "This browser shows no 3-D graphics (WebGL), so the figures cannot be drawn. The tables below work all the same.",
    mostChosen: "Four at most: take one away first",
    trial: "Trial held out",
    models: (most: number) => `Models to show, at most ${most}`,
    noMotions: "A file of results holds no motions: press Compare with the clips to see the models move.",
    empty: "Press Compare: the models will walk here side by side, each with the real trial as an outline.",
    stage: (count: number) =>
      `${count} predictions of the trial side by side, each with the real trial as an outline. Drag to look from another side; with the keyboard: w, a, s, d.`,
    about:
      "In colour: what the model predicts from the trial’s first five frames. Outline: the real trial, laid on top.",
    of: (frames: number) => `of ${frames}`,
    toStage: "Put on the stage",
    toStageMeaning: "In the Lab, the model that was trained without this trial: to move, save and share it",
  },
  distance: {
    heading: "Distance from the real trial",
    none: "Nothing is shown.",
    axis: "Mean distance of the joints, cm",
    time: "Time, seconds",
    label: (found: string) => `Mean distance of the joints from the real trial: ${found}.`,
    centimetres: (model: string, distance: string) => `${model} ${distance} centimetres`,
    caption:
      "Of a body 1.7 m tall, with the hips laid on the real ones. The error in the table is that of joint rotations and the root’s movement after warping in time: to be early or late counts here, and little there.",
  },
  table: {
    heading: "Error, bound, time and size of each model",
    none: "No model has been trained and scored yet.",
    converged: (per100: number) => `, ${per100} % converged`,
    standsFor: (settings: number) => ` (of ${settings} settings)`,
    noValue: "none",
    median: (value: string) => `median ${value}`,
    model: "Model and settings",
    oneSize: "One size of each model",
    all: (settings: number) => `All ${settings} settings`,
    representatives:
      "Of settings that differ in size alone, the one is shown that is chosen most often over the trials, by the error of rollouts on the trials trained on. What is best, highest, quickest and fewest is so among those shown.",
    caption:
      "The error is the [mean squared error after dynamic time warping|dtw]; the [bound|bound] is in [nats|nats]. Error, time and size are drawn on log scales. The dashed line is the error of a prediction that does not move.",
    measures: {
      error: { title: "Error", unit: "DTW MSE", best: "best" },
      bound: { title: "Bound", unit: "nats", best: "highest" },
      training: { title: "Training", unit: "seconds", best: "quickest" },
      size: { title: "Size", unit: "numbers stored", best: "fewest" },
    },
  },
  correlation: {
    heading: "Error against bound",
    none: "Needs a model with a bound, scored under three or more settings, such as numbers of inducing points.",
    error: "DTW MSE, log scale",
    bound: "Bound, nats",
    labels: (units: string) => `Labels: ${units}.`,
    allWith: (all: string) => `All with ${all}.`,
    caption:
      "Where the bound is a good guide, the points fall from left to right: rank correlation near −1. Each panel has scales of its own.",
    rank: (rank: string | null, settings: number) =>
      `${rank === null ? "no rank correlation" : `rank correlation ${rank}`} over ${settings} ${settings === 1 ? "setting" : "settings"}`,
    tooFew: "too few settings to say more",
    smaller: "a higher bound goes with a smaller error",
    larger: "a higher bound goes with a larger error",
    little: "the bound says little about the error",
    finding: (model: string, rank: string, says: string) =>
      `${model}, error against bound: ${rank}; ${says}.`,
  },
  growth: {
    heading: "Learning time against frames",
    none: "Needs a model trained on three or more numbers of trials.",
    seconds: "Seconds an iteration, log scale",
    frames: "Frames trained on, log scale",
    caption:
      "Time grows with the frames to the power of the exponent: 1 is twice the time for twice the frames, 3 is eight times.",
    exponent: (exponent: string | null) => (exponent === null ? "no exponent" : `exponent ${exponent}`),
    finding: (lines: string) => `Seconds an iteration against frames, both on log scales: ${lines}.`,
  },
  claims: {
    heading: "What the papers say",
    none: "No claim of the papers can be checked with the models scored so far.",
    heads: ["The papers say", "We find", "Holds here"],
    criterion: "Our criterion:",
    answers: { yes: "yes", no: "no", undecided: "undecided" },
    caption:
      "Errors are held against each other trial by trial; the intervals cover 95 %. Yes and no are said only where the whole interval says so.",
  },
  finding: {
    oneTrial: "One trial was held out and predicted; how it would be with others is not known yet.",
    trials: (least: number, most: number) =>
      `Mean ± standard error over ${least === most ? most : `${least} to ${most}`} trials, each held out in turn and predicted; the bars are the standard errors.`,
    lowest: (model: string) => `${model} has the lowest mean error here, by more than both standard errors.`,
    undecided: (one: string, other: string) =>
      `Which model has the lowest error here is undecided: ${one} and ${other} differ by less than their standard errors together.`,
    own: (ratio: string, decided: boolean) =>
      ` The error of the vCGPDM is ${ratio} times the lowest${decided ? "" : ", which is undecided too"}.`,
  },
  empty: "Nothing to compare yet. Each model appears here when its first trial has been predicted.",
};

export type CompareWords = typeof words;
