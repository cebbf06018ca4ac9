import { decimal } from "../../ui/decimal";

const number = (value: number, digits = 0) => decimal("en", value, digits);
const times = (count: number) => (count === 1 ? "once" : `${count} times`);

/** The panel Learn: clips, the settings of a training, its course and its end. */
export const learn = {
  clips: {
    title: "Clips",
    body: "body",
    bodyOf: (title: string) => `Which body of ${title}`,
    assumed: (why: string, fps: number) =>
      `Read at ${fps} frames a second, because its own frame time is none: state the rate. (${why})`,
    rate: "frames a second",
    rateOf: (title: string) => `Frames a second of ${title}`,
    up: "up",
    upAxis: (title: string) => `Axis that points up in ${title}`,
    frames: (title: string) => `Frames of ${title} to use`,
    side: {
      first: (title: string) => `First frame of ${title}`,
      end: (title: string) => `Last frame of ${title}`,
    },
    from: "from",
    to: "to",
    of: (frames: number) => `of ${frames} frames`,
    tick: (title: string) => `Train on ${title}`,
    seconds: (seconds: number) => `${number(seconds, 1)} s`,
    cut: "Cut",
    cutOf: (title: string) => `Cut ${title}`,
    show: (title: string) => `Show ${title}`,
    stopShowing: (title: string) => `Stop showing ${title}`,
    onStage: "Show on the stage",
    backToModel: "Back to the model",
    remove: "Remove",
    removeOf: (title: string) => `Remove ${title}`,
    notices: (count: number) => `${count} ${count === 1 ? "notice" : "notices"}`,
    bonesClash: "Their joints are the same, only their bones differ.",
    firstBones: "Use the first clip’s bones",
    bones: (title: string) =>
      `All ticked clips are trained on with the bones of ${title}: joint angles stay, the way over the ground is scaled by the height of the root.`,
    ownBones: "Use their own bones",
    openOwn:
      "Open your own motion clips (.bvh) or a model (.json), or drop them anywhere. They stay on this machine.",
    series: "Time series",
    seriesView: "that are no body (.csv) have a view of their own.",
    samples: "Samples, made by a program",
    recorded: "Movements of real people",
    ticked: (ticked: number, all: number) => `${ticked} of ${all} ticked, to train a new model on`,
    gettingReady: "Getting the sample clips ready",
    trim: (title: string) => `Trim ${title}`,
    keep: "Keep",
    trimSide: {
      first: (title: string) => `Trim the start of ${title}`,
      end: (title: string) => `Trim the end of ${title}`,
    },
    frame: (frame: number, time: string) => `frame ${frame}, ${time}`,
    range: (from: string, to: string) => `${from} to ${to}`,
  },
  parts: {
    choose: "Choose a joint’s part; the joints below it go along.",
    joints: "Joints and their parts",
    member: (name: string) => `Part of ${name}`,
    name: (place: number) => `Name of part ${place}`,
    remove: (name: string) => `Remove part ${name}`,
    heir: { joints: "Its joints go to another", columns: "Its columns go to another" },
    empty: { joints: "No joints: left out of training", columns: "No columns: left out of training" },
    add: "Add a part",
    free: (place: number) => `part ${place}`,
    noName: "A part needs a name.",
    taken: (name: string) => `Another part is called “${name}”.`,
  },
  field: {
    atMost: (limit: string) => `At most ${limit}.`,
    atLeast: (limit: string) => `At least ${limit}.`,
    about: (label: string) => `${label}: what is that?`,
  },
  settings: {
    parts: "Parts",
    partsToTrain: "The parts to train",
    byHand: "By hand",
    joints: (count: number) => `${count} ${count === 1 ? "joint" : "joints"}`,
    latent: { label: "Latent dimensions", hint: "The dimensions of each part’s latent space" },
    dynamicsIps: { label: "Dynamics points", hint: "Inducing points of each coupling’s dynamics" },
    poseIps: { label: "Pose points", hint: "Inducing points of each part’s pose map" },
    whyPoints: (points: number, seconds: string) =>
      `${points} points, because the longest clip has ${seconds} seconds.`,
    framesPerSecond: { label: "Frames a second", hint: "Clips are resampled to this rate" },
    advanced: "Advanced",
    seed: "Seed",
    newSeed: "New seed",
    trainings: {
      label: "Trainings",
      hint: "One for each seed from this one on, as many at once as this machine has cores; 0: as many as cores, up to 4",
    },
    order: { label: "Frames of history", hint: "The order of the dynamics" },
    maxIterations: { label: "Iterations at most", hint: "The optimiser stops here at the latest" },
    poseWeight: {
      label: "Weight of the poses",
      hint: "balanced: poses count as much as dynamics, so that the latents are easier to predict. 1: training maximises the bound",
      value: (weight: number | "balanced") => String(weight),
    },
    asInPapers: {
      label: "As in the papers",
      hint: "Weight 1 of the poses, no learning from own rollouts: training maximises the bound",
    },
  },
  training: {
    title: "Training",
    train: "Train",
    cancel: "Cancel",
    cancelMeaning: "Stops here and keeps what was learned so far",
    add: "Add",
    addMeaning: "Trains with the settings below too, beside the others",
    continue: (more: number) => (more > 0 ? `Continue, ${more} more` : "Continue"),
    continueMeaning: (seed: number, more: number) =>
      `Goes on where seed ${seed} stopped${more > 0 ? `, for ${more} more iterations` : ", as if it had not been cancelled"}`,
    iteration: (iteration: number) => `Iteration ${iteration}`,
    iterationOf: (iteration: number, most: number) => `Iteration ${iteration} of ${most}`,
    settingUp: "Setting up",
    stopping: "Stopping",
    catchingUp: "Catching up with where it stopped",
    done: (over: number, all: number) => `${over} of ${all} trainings done`,
    failed: (why: string) => `Training failed: ${why}`,
    share: (per100: number) => `Training, ${per100} per cent of the iterations`,
    started: "Training started",
    cancelling: "Cancelling",
    ended: (how: string) => `Training ended. ${how}`,
    estimating: "estimating the time left",
    left: (time: string) => `at most ${time} left`,
    leftAbout: (time: string) => `about ${time} left`,
    stopsHere: "Stops here and keeps the best so far",
    goingShare: (going: string, per100: number) => `${going}, ${per100} per cent done`,
    whyNot: {
      gettingReady: "Getting ready",
      cannotRun: "The model cannot run in this browser",
      samples: "Getting the sample clips ready",
      tick: "Tick at least one clip to train on",
      clash: "The ticked clips do not go together; Clips says why",
    },
    /** `made`: all clips are samples. */
    newModels(trainings: number, clips: number, made: boolean): string {
      const models = trainings === 1 ? "A new model" : `${trainings} new models`;
      const sample = made ? "sample " : "";
      const of =
        clips === 1 ? `ticked ${sample}clip and its body` : `${clips} ticked ${sample}clips and their body`;
      return `${models}, of the ${of}.`;
    },
    /** `gigabytes`: null: not worth a warning. */
    cost: (time: string, gigabytes: number | null) =>
      `At most about ${time}.${gigabytes === null ? "" : ` It needs about ${number(gigabytes, 1)} GB of memory.`}`,
    shorter: "Fewer frames a second, points or iterations make it shorter.",
    days: (days: number) => `${days} days`,
    hours: (hours: number) => `${hours} hours`,
    about: "About this training",
    workerGone: "The worker that trained it is gone.",
    notTakenUp: (seed: number) => `The model of seed ${seed} was not taken up`,
  },
  ending: {
    settled: "the objective no longer rises",
    iterations: "all iterations used",
    done: "Done.",
    left: "You left the page; this is the best so far.",
    stopped: "You cancelled; this is the best so far.",
    notBegun: "You cancelled before it began.",
    jittered: (count: number) => `A covariance needed jitter on its diagonal ${times(count)}.`,
    turnedBack: (count: number) => `The search turned back ${times(count)} where there was no finite number.`,
    count: (count: number, state: "done" | "cancelled" | "failed") => `${count} ${state}`,
    best: (seed: number, soFar: boolean) =>
      ` The best${soFar ? " so far" : ""}, seed ${seed}, is on the stage`,
    closer: (seed: number) =>
      `: its motion is closer to the clips than that of seed ${seed}, whose objective is higher`,
    keepsMoving: "keeps moving",
    worse: (how: string, seed: number, otherHow: string) =>
      `: it ${how}, while seed ${seed}, whose objective is higher, ${otherHow}`,
    motion: {
      breaksDown: "breaks down",
      rests: "rests as recorded",
      farFromClips: (since: string) => `gets far from its clips${since && ` ${since}`}`,
    },
  },
  phases: {
    "couplings-kernels-inducing-points": "couplings, kernels and inducing points",
    everything: "everything together",
    "own-rollouts": "watches its own motion and learns from it",
  },
  runs: {
    title: "Trainings",
    clear: "Clear",
    state: {
      waiting: "waiting",
      running: "running",
      done: "done",
      cancelled: "cancelled",
      failed: "failed",
    },
    progress: (seed: number) => `Training of seed ${seed}`,
    takeUp: "Take this model up on the stage",
    show: (seed: number) => `Show seed ${seed}`,
    best: "the best",
    remove: (seed: number) => `Remove seed ${seed}`,
    bound: "Objective",
    iterations: "Iterations",
    iterationsHead: "It.",
    time: "Time",
    clips: "Clips",
    joints: (name: string, count: number) => `${name} (${count} joints)`,
    heads: { framesPerSecond: "fps", maxIterations: "at most", poseWeight: "weight" },
    comparable:
      "Comparable only on the same frames with the same weight of the poses; the chart shows those.",
  },
  bound: {
    name: "Evidence lower bound",
    weighted: "Weighted objective",
    in: "in",
    nats: "nats",
    seed: (seed: number) => `seed ${seed}`,
    overIterations: "The objective over the iterations",
    empty: "It rises here while a model trains.",
    terms: "Terms of the bound",
    termsOverIterations: "The terms of the bound over the iterations",
    poses: (part: string) => `poses, ${part}`,
    dynamics: (part: string) => `dynamics, ${part}`,
    entropy: "entropy",
    firstFrames: "first frames",
  },
};

export type LearnWords = typeof learn;
