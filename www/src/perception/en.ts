import { study } from "./study-en";

const people = (count: number) => `${count} ${count === 1 ? "participant" : "participants"}`;

/** The view Which is natural?: the graphics Turing test. */
export const words = {
  standard: study,
  title: "Which is natural?",
  about:
    "Two movements side by side, one natural, one made by a model. The more often people take the model’s for the natural one, the better the model.",
  setup: "The experiment",
  found: "Answers",
  participant: "Participant",
  code: "a code at random",
  codeMeaning: "A code, no name",
  begin: "Begin",
  simulate: "Simulate",
  simulateMeaning: "The program answers, to try the experiment out",
  privacy:
    "This page records no person and sends nothing. Answers stay in this browser until you save or forget them.",
  here: "On this machine",
  answersSay: "What the answers say",
  elsewhere: "Run it elsewhere",
  /** Around the name of a file, an address, and the name of another file. */
  elsewhereText: [
    "Put the built page on any static host, with your study as",
    ", and give out its address with",
    ". In JATOS the built folder is the study’s assets, and",
    "the component. Nothing is sent there either: participants save their file and hand it in.",
  ],
  study: {
    title: "Study",
    save: "Save study",
    open: "Open study",
    openMeaning: "Open a study (.json)",
    loading: "Loading the study.",
    openFirst: "Open a study (.json) to begin.",
    none: "There is no study yet.",
    tooLarge: "This file has more than 200 MB; expected a study.",
    unsaved: (title: string) => `the study “${title}” as it was made or changed here`,
    /** `pause`: how long pauses are at least; null: there is one block. */
    design: (trials: number, blocks: number, pause: string, minutes: number) =>
      `${trials} trials${blocks > 1 ? ` in ${blocks} blocks, pauses of at least ${pause} between` : ""}, about ${minutes} minutes.`,
    movements: (natural: number, generated: number, failed: number) =>
      `${natural} natural and ${generated} generated movements, ${failed === 0 ? "none of them marked as failed" : `${failed} of them marked as failed`}.`,
    plan: "Plan",
    plans: {
      class: { name: "Class", meaning: "A short one, for a class" },
      "p3-part-1": { name: "P3, part 1", meaning: "As in the first part of Knopp et al. (2019)" },
      "p3-part-2": { name: "P3, part 2", meaning: "As in the second part of Knopp et al. (2019)" },
      p2: { name: "P2", meaning: "As in Velychko et al. (2018)" },
    },
    planLength: (trials: string, minutes: number) => `${trials} trials, ${minutes} min`,
    points: "Point lights",
    pointsMeaning: "Dots at the joints instead of grey figures.",
    texts: {
      title: "What participants read",
      consent: "Consent",
      instructions: "Instructions",
      question: "Question of each trial",
      pause: "Pause",
      end: "After the last trial",
      hint: "An empty line begins a new paragraph. The texts are saved with the study. Texts that nobody has changed appear in the language of the page.",
    },
    marks: {
      title: "Movements that check attention",
      hint: "Tick those that have obviously failed, for [attention checks|attention-check]. They are left out of the comparison, and who takes more than 15 % of them for natural is left out too.",
      look: "Look at it beside the natural one",
      lookAt: (id: string) => `Look at ${id}`,
    },
  },
  riddle: {
    title: "Which one is the model?",
    about:
      "Two walks as points of light. In the study of this page the natural one is a program that walks by published curves of people’s gait; the model saw other walks of it. This counts in no study.",
    play: "Let them walk",
    question: "Your guess:",
    right: "Yes.",
    wrong: "No, the other one.",
    score: (found: number, asked: number) =>
      `You found ${found} of ${asked}. Guessing alone finds about half of them.`,
    next: "Next pair",
  },
  look: {
    label: "A movement",
    close: "Close",
    natural: "Natural",
    generated: "Generated",
    failed: "The movement cannot be shown",
  },
  run: {
    agree: "I agree",
    begin: "Begin",
    goOn: "Go on",
    done: "Done",
    wait: (seconds: number) => `You can go on in ${seconds} s.`,
    left: "← Left",
    right: "Right →",
    progress: "Trials answered",
    of: (done: number, all: number) => `${done} of ${all}`,
    leave: "Leave",
    leaveMeaning: "The answers so far are kept: you can go on later",
    notShown: "The movements cannot be shown",
    noGraphics: "This browser shows no 3-D graphics (WebGL). Answers can still be analysed.",
    stopped: "The experiment stopped",
    otherTab: "Another tab of this browser goes on with it.",
    noStudy: "The study that it belongs to is not on this machine any more.",
  },
  participants: {
    label: "Participants",
    heads: ["Participant", "Study", "Answered"],
    files: "Files",
    simulated: "simulated",
    classCode: "The answers in one code, for a class",
    goOn: "Go on",
    csv: (name: string) => `CSV of ${name}`,
    json: (name: string) => `JSON of ${name}`,
    forget: "Forget",
    forgetOf: (name: string) => `Forget ${name}`,
    sureToForget: (answers: number, name: string) =>
      `Forget the ${answers} answers of ${name}? They are on no other machine, unless you saved them.`,
    notKept: (why: string) =>
      `This browser does not keep the answers (${why}): save them before you leave the page.`,
    keepsNothing: "this browser keeps nothing",
    nobody:
      "Nobody has answered on this machine yet. Answers appear here as they come, and stay when the tab is closed.",
    allCsv: "All as one CSV",
    allJson: "All as one JSON",
  },
  codes: {
    title: "Codes of a class",
    label: "One code in each line",
    analyse: "Analyse the codes",
    notRead: "The codes were not read",
    sign: (found: string) => `expected letters and digits, found “${found}”`,
    notWhole: "expected a whole code, found a mistyped or incomplete one",
    otherStudy: "expected a code of the open study, found one of another study",
    line: (line: number, why: string) => `line ${line}: ${why}`,
  },
  analysis: {
    here: "Analyse those on this machine",
    open: "Open answers",
    openMeaning: "Open the answers (.csv or .json) of one or more participants",
    save: "Save results",
    files: "Files",
    leaveOut: "Leave out",
    leaveOutOf: (name: string) => `Leave out ${name}`,
    busy: "Analysing",
    empty: "Drop the files of all participants here. The study that they answered must be open.",
    tooLarge: (name: string) => `${name} has more than 200 MB; expected answers.`,
    notOpened: "The answers were not opened",
    notSaved: "The results were not saved",
    fileNotSaved: (name: string) => `${name} was not saved`,
    participants: "Participants",
    participantsLabel: "Participants of the analysis",
    heads: ["Participant", "Answers", "Attention checks passed", "Median answer, s", "Left", "Counts"],
    unanswered: (count: number) => `${count} not answered`,
    of: (hits: number, all: number) => `${hits} of ${all}`,
    noneShown: "none shown",
    leftOut: "left out",
    counts: "yes",
    count: (trials: number, participants: number, share: string) =>
      `${trials} answers of ${people(participants)}: the model’s movement was taken for the natural one in ${share}.`,
    excluded: (count: number, limit: string) => ` ${count} left out, below ${limit} of the attention checks.`,
    caught: (trials: number, hits: number, probability: string) =>
      `Of ${trials} [catch trials|catch-trial] the movement not seen before won ${hits}: at equal odds beforehand, these answers are chance with probability ${probability}, as if nobody knew the others by heart.`,
    needed: (toTell: number, forPrecision: number) =>
      `A setting needs ${toTell} answers to tell a rate 0.1 below one half (one-sided at 5 %, power 0.8), and ${forPrecision} until a rate found to be one half is within 0.05 of it with probability 0.8.`,
  },
  figures: {
    needsModel: "Needs answers about a model’s movements.",
    needsBlocks: "Needs answers about a TMP or a DMP.",
    needsPoints: "Needs answers about a vCGPDM or a vGPDM.",
    bars: "Bars: one standard deviation of the rate’s posterior.",
    moreAnswers: "ln K needs more answers",
    tooFew: "too few settings",
    atMost: (value: string) => `at most ${value}`,
    over: (up: string, across: string) => `${up} over ${across}`,
    settings: (what: string, count: number) => `${what}, ${count} settings`,
    measures: {
      rate: { name: "confusion rate", axis: "Confusion rate" },
      mse: { name: "test MSE", axis: "Test MSE" },
      "training-mse": { name: "training MSE", axis: "Training MSE" },
      bound: { name: "bound", axis: "Bound, nats" },
      dynamics: { name: "dynamics part of the bound", axis: "Dynamics part, nats" },
      pose: { name: "pose part of the bound", axis: "Pose part, nats" },
      points: { name: "inducing points (soft minimum)", axis: "Inducing points, soft minimum" },
    },
    logarithmic: (axis: string) => `${axis}, log scale`,
    poses: "Pose points",
    dynamics: "Dynamics points",
    scores: {
      heading: "Confusion rate over each score",
      caption:
        "Curves: logistic regression with a ceiling of one half. [ln K|ln-k] compares it with the best constant, each tried on answers that it was not fitted to: above 0 the score predicts these answers better than the constant does; with few settings that can be chance. No score has more than the number after “at most”: each setting’s own rate reaches it. The soft minimum of the numbers of dynamics and pose inducing points is near the smaller one.",
    },
    all: {
      heading: "All models over the test error",
      title: "All models",
      label: (settings: number, models: number) =>
        `Confusion rate over test MSE of ${settings} settings of ${models} models`,
      caption: "The curve is fitted to all settings at once.",
    },
    rates: {
      heading: "Over the number of primitives or bases",
      blocks: { primitives: "Primitives", bases: "Bases" },
      value: (value: string, count: number, blocks: "primitives" | "bases") =>
        `${value} with ${count} ${blocks}`,
      caption: "At 0.5, the dashed line, nobody can tell the model’s movement from the natural one.",
    },
    maps: {
      heading: "Confusion rate over inducing points",
      label: (model: string) =>
        `${model}: confusion rate for each number of pose and dynamics inducing points`,
      failed: "failed",
      caption: "White: obviously failed models, which checked whether participants looked.",
    },
    inducing: {
      heading: "What inducing points do",
      lines: (measure: string) => `${measure} for numbers of pose points`,
      linesOf: (measure: string, counts: string) =>
        `${measure}, a line for each number of pose points: ${counts}`,
      caption:
        "An ellipse is the wider, the more dynamics inducing points a setting has, and the higher, the more pose inducing points.",
      paper:
        "As figure 6 of Velychko et al. (2018), with the error on the clips that the model learned from. The curve of this error over the bound is exponential, a straight line on a log scale: it fits the logarithm of the error by least squares.",
    },
    pairwise: {
      heading: "The best of each model",
      model: "Model and its best settings",
      rate: "Confusion rate",
      aboveHalf: "P(rate > ½)",
      betterThan: "better than",
      caption:
        "Each row: how probable it is that the model’s best setting has a higher rate than that of the column, from the posteriors of both.",
      order: (probability: string, order: string) =>
        `The likeliest order, with probability ${probability}: ${order}.`,
    },
  },
};

export type PerceptionWords = typeof words;
