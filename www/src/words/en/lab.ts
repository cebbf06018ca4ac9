import startPresets from "../../../first/presets.json";
import { decimal } from "../decimal";
import { learn } from "./learn";
import { loops } from "./loops";
import { files } from "./files";

type PresetWords = { name: string; meaning: string };

const number = (value: number, digits: number) => decimal("en", value, digits);
const capital = (name: string) => name.charAt(0).toUpperCase() + name.slice(1);

/** The meanings of the presets of the model that the page opens with, by id. */
const START_MEANINGS: Record<string, string> = {
  "as-learned": "Legs and arms as training coupled them.",
  "arms-go": "The arms no longer hear the legs. What they do alone is inferred again from the clips.",
  "arms-hang": "The arms no longer hear the legs. They do what they learned together with the legs.",
  "arms-follow": "The arms no longer hear themselves, only the legs.",
  "arms-lead": "The legs no longer hear themselves, only the arms.",
  "untrained-advice": "Arms learned nothing about legs. The legs hear them a little.",
  "legs-lost": "Arms learned nothing about legs. The legs hear half themselves, half the arms.",
};

/** The Lab: its frame, the stage, and the tab Listen. A [text|term] in brackets is a term with an explanation. */
export const lab = {
  files,
  learn,
  loops,
  /** Names of parts, and titles of splits by their ids: those of the library, which are English already. */
  partNames: {} as Readonly<Record<string, string>>,
  splits: {} as Readonly<Record<string, string>>,
  title: "Coupled [movement primitives|movement-primitive]",
  views: {
    play: "Lab",
    compare: "Compare models",
    primitives: "Primitives",
    synthetic: "Who drives whom?",
    perception: "Which is natural?",
    method: "Method",
    series: "Time series",
  },
  leads: {
    compare: "Which model foresees a walk best, and what does it cost?",
    primitives: "Parts learned once, put together in new ways: legs of one movement, arms of another.",
    synthetic: "Two made-up systems of which the truth is known: does training find it?",
    series: "Curves that are no body: which parts they have, and which part drives which.",
    perception: "The graphics Turing test: can people tell a model’s movement from a natural one?",
    method: "The model in equations, and where each symbol is to be seen.",
  },
  header: {
    files: "Files",
    open: "Open",
    openMeaning: "Open a model (.json), clips (.bvh) or tables (.csv)",
    help: "Help and keys",
    newVersion: "Load new version",
    newVersionMeaning:
      "A new version of this page is there. Loading it begins anew: save first what you want to keep.",
  },
  page: {
    tabs: { listen: "Listen", loops: "Loops", learn: "Learn", numbers: "Numbers" },
    panels: "Panels",
    skipToCouplings: "Skip to the couplings",
    skipToContent: "Skip to the content",
    loading: "Loading",
    notLoaded: "This part of the page could not be loaded.",
    reload: "Reload the page",
    foreignLink: (linked: string, here: string) =>
      `This link’s couplings belong to another model (${linked}), not to the one on the stage (${here}). They are applied when that model is opened.`,
    forgetLink: "Forget them",
    failed: (why: string) =>
      `The model cannot run here: ${why} The walk below is a stored rollout; sliders and training need the model.`,
    stopped: (why: string) =>
      `${why} Load the page again: it then offers to bring back your clips and models.`,
    keepAndReload: "Keep everything and reload",
    local: "Nothing you load leaves your machine.",
    data: "Data",
    licences: "licences",
    leaveLarge: "Leave the projector mode",
    leaveLargeKey: "Leave the projector mode (Escape)",
    drop: "Drop motion clips (.bvh), tables (.csv) or a model (.json)",
  },
  stage: {
    made: "Made by the model",
    lead: {
      made: "This motion was never recorded: a small model made it.",
      learned: (clips: string) => `This motion was never recorded: a small model learned it from ${clips}.`,
      learning: "A model is learning: what it can do so far moves on the stage.",
      own: "Couplings of your own, not those that the model learned.",
      clip: "This is a clip: what a model learns from, not what it made.",
      back: "Back to as learned",
      question: "do they keep step?",
    },
    rollout: "A [rollout|rollout]",
    otherKind: {
      made: (kind: string) => `Made by a ${kind}`,
      noCouplings: "A model without couplings: nothing here changes its motion",
    },
    clip: "Clip",
    clipFrom: {
      made: "A clip, made by a program: not the model",
      model: "A clip, made by a model that learned from recordings",
      own: "A clip, as it was recorded: not the model",
    },
    point: "What an inducing point stands for",
    posePoint: (part: string) => `A pose of ${part}`,
    stepPoint: (source: string, target: string) => `From this pose of ${source} to that of ${target}`,
    changed: "Couplings changed",
    live: "The model goes on live",
    twoReadings: "The same couplings, read in two ways",
    outline: "The outline moves as the model learned it",
    changeOne: "change a coupling to see two readings of it",
    learning: "The model while it learns",
    starting: "Starting",
    iteration: (iteration: number, seed: number | null) =>
      `Iteration ${iteration}${seed === null ? "" : `, seed ${seed}`}`,
    learnedFrom: (names: string) => `learned from ${names}`,
    clips: (count: number) => (count === 1 ? "one clip" : `${count} clips`),
    and: (names: readonly string[]) => names.join(" and "),
    backToModel: "Back to the model",
    health: (words: string, altered: boolean) =>
      `${altered ? "With these couplings the model" : "The model"} ${words}`,
    asLearned: "Couplings as learned",
    morePoints: "Train with more points",
    morePointsMeaning: (points: number) => `Trains anew with ${points} points in each map`,
    otherSeeds: "Try other seeds",
    otherSeedsMeaning: "Trains anew from the next seeds",
    figure:
      "A figure walking. Drag to look from another side, scroll to come closer; with the keyboard: w, a, s, d, plus and minus.",
    figures: (titles: readonly string[]) =>
      `${titles.length} figures side by side: ${titles.join(", ")}. Drag to look from another side; with the keyboard: w, a, s, d.`,
    noGraphics:
      "This browser shows no 3-D graphics (WebGL), so the figure cannot be drawn. The latent plots, couplings and training work all the same.",
    graphicsLost:
      "The browser has taken the 3-D graphics away, perhaps because other pages need them. The figure comes back when it gives them back; reloading the page may help.",
  },
  clock: {
    clock: "Phase clock: one hand for each part, which turns once in each of its periods",
    seconds: (seconds: number) => `${number(seconds, 2)} s`,
    still: "keeps one pose",
    step: { "in step": "in step", "partly in step": "partly in step", "out of step": "out of step" },
  },
  presets: {
    label: "Presets",
    /** Of the model that the page opens with, by id. */
    start: Object.fromEntries(
      startPresets.map(({ id, name }) => [id, { name, meaning: START_MEANINGS[id] ?? "" }]),
    ) as Record<string, PresetWords>,
    learned: { name: "As learned", meaning: "The parts as training coupled them." },
    alone: (part: string) => ({
      name: `${capital(part)} on its own`,
      meaning: `What the other parts say about ${part} hardly counts.`,
    }),
    follows: (part: string) => ({
      name: `${capital(part)} follows the others`,
      meaning: `What ${part} says about itself hardly counts.`,
    }),
  },
  couplings: {
    map: "Couplings on the body",
    drives: (source: string, target: string) => `${source} drives ${target}`,
    itself: "itself",
    arrows:
      "Arrows: which [part|part] drives which ([coupling|coupling]). Drag one up or down: thicker, thinner. Hold it: cut.",
    weight: (names: string, now: string, learned: string | null) =>
      `${names}: weight ${now}${learned === null ? "" : ` (learned: ${learned})`}`,
    knob: (weight: string, alpha: string, learned: string) =>
      `weight ${weight}, alpha ${alpha}; learned ${learned}`,
    failed: "The model could not be started, so its couplings cannot be changed.",
    empty: "How the parts drive each other appears here.",
    onePart: "This model has one [part|part], so no part drives another. Train one with two parts or more.",
    completing: "Let a recording move one part",
    numbers: "Numbers",
    table: "A row decides about a column. Right is strong: small [α|alpha], large [w|weight].",
    startAs: "Start as clip",
    startLabel: "Start as in",
    trainedOn: "Trained on",
    notTrainedOn: "Not trained on",
    clipStart: (seconds: string) =>
      `The model infers the first ${seconds} s from the clip, then goes on by itself. A link does not keep this start.`,
    startFailed: "The motion cannot start with this clip",
    fromFrame: "from frame",
    frame: (frame: number, count: number) => `Frame ${frame} of ${count}`,
    decides: "who decides",
    about: "about",
    pair: (source: string, target: string) => `${source} to ${target}`,
    tick: (alpha: string, trained: boolean) => `${trained ? "As learned" : "As it was"}: ${alpha}`,
    value: (alpha: string, weight: string, learned: string | null) =>
      `alpha ${alpha}, weight ${weight}${learned === null ? "" : `; learned ${learned}`}`,
    slider: (pair: string) => `${pair}: drag to change, double click to reset`,
    alphaMeaning: "alpha, the variance of this prediction: small means influential",
    weightMeaning: "weight of this prediction; the weights into a part sum to 1",
    bar: "Drag a border: one gains what the other loses. Double click to reset.",
    border: (target: string, one: string, other: string) =>
      `Who decides where ${target} goes next: ${one} or ${other}`,
  },
  live: {
    hint: "Hold an arrow of the body map to cut that coupling. Drag a limb or turn the wheel to move a part yourself; drag the dot of a latent plot to push it.",
    driven: (part: string) => `You move ${part}. The others follow as the couplings say.`,
    wheel: (part: string) => `Wheel: moves ${part} through its step. Arrow keys turn it, Escape lets go.`,
    wheelMeaning: "Drag the rim: one turn is one step cycle. Let go, and the model goes on.",
    movers: "Who moves each part",
    mover: (part: string) => `Who moves ${part}`,
    model: "the model",
    you: "you",
    recording: "a recording",
    recorded: (part: string, title: string) => `A recording moves ${part}: ${title}. Outline: the recording.`,
    cuts: (count: number) => `${count} couplings are cut`,
    cut: (source: string, target: string) => `${target} does not hear ${source}`,
    ahead: (part: string) => `ahead of ${part}, in turns`,
    distance: "distance from the learned cycle",
    chart: (first: string, others: readonly string[]) =>
      `Strip chart: how far ${others.join(", ")} ${others.length > 1 ? "are" : "is"} ahead of ${first}, and how far each part is from the learned cycle`,
    noPhase: "This motion does not repeat itself, so there is no phase to show.",
    notBegun: "The live motion could not begin",
    ended: "The live motion has ended",
    stays: "This coupling stays",
    staysWhy: "Nothing else would say where the part goes next.",
  },
  readings: {
    label: "[Experts|expert], when a coupling changes",
    about: "What do as learned and re-inferred mean?",
    text: { "re-inferred": "re-inferred", "as-learned": "as learned" },
    side: { "as-learned": "Left, as learned", "re-inferred": "Right, re-inferred" },
    experts: (reading: string) => `Experts ${reading}`,
    meaning: {
      "re-inferred": "What the same clips would have taught each part’s predictions under these couplings.",
      "as-learned": "Only the weights change: each part predicts as before, and counts for more or less.",
    },
    both: "Left: training made the experts as a team, and one left alone does only its share. Right: as the same clips teach one that was always alone.",
    bothButton: "Both side by side",
    resetAll: "Reset all",
  },
  measured: {
    compared: (reading: string) =>
      `[Measured|measured]${reading && ` ${reading}`}, compared with as learned:`,
    since: (seconds: number) => `from ${number(seconds, 1)} s on`,
    pose: (since: string) => `keeps one pose ${since}`,
    figure: (trouble: string) => `the figure ${trouble}`,
    asLearned: "hands and feet swing as learned",
    common: (step: string) => `hands and feet ${step}`,
    swingsBy: (centimetres: number) => `swings ${number(centimetres, 0)} cm`,
    swings: (share: number, hardly: boolean) =>
      `${hardly ? "hardly swings, " : "swings "}${number(share, 2)} × as far`,
    noPace: "without a steady pace",
    pace: (is: number, was: number) =>
      `${is > was ? "slower" : "faster"} (${number(is, 2)} s, not ${number(was, 2)} s)`,
    speed: (share: number) => `walks ${number(share, 2)} × as fast`,
    step: { "in step": "in step", "partly in step": "partly in step", "out of step": "out of step" },
    aPart: "a part",
    standsStill: (since: string) => `stands still ${since}`,
    visits: (share: number, part: string) =>
      `visits ${Math.round(100 * share)} % of its clips’ poses in ${part}`,
    leaves: (part: string, since: string) => `${part} leaves the training range ${since}`,
    shakes: (part: string | null, times: number | null, turnsBack: number) =>
      `shakes: ${part ?? "the body"} moves ${times === null ? "" : `${number(times, 1)} × as fast as in its clips, `}and ${Math.round(100 * turnsBack)} % of its steps turn back`,
    runsAway: "runs away: its numbers are too large to show",
  },
  time: {
    label: "Time",
    play: "Play",
    pause: "Pause",
    playMeaning: "Play (space)",
    pauseMeaning: "Pause (space)",
    back: "One frame back",
    backMeaning: "One frame back (left arrow)",
    forward: "One frame forward",
    forwardMeaning: "One frame forward (right arrow)",
    modes: "Clip or live",
    clip: "clip",
    clipMeaning: "A motion of some seconds, again and again",
    live: "live",
    liveMeaning: "The model goes on from here without an end: cut couplings and move parts while it moves",
    frame: "Frame",
    frameOf: (frame: number, count: number) => `Frame ${frame} of ${count}`,
    length: "Length of the motion in seconds",
    lengthMeaning: (least: string, most: string) => `How long the model goes on, ${least} to ${most} seconds`,
    loop: "Loop",
    speed: "Speed",
  },
};

export type LabWords = typeof lab;
