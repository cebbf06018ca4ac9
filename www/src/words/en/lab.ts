import startPresets from "../../../first/presets.json";
import { decimal } from "../../ui/decimal";
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

/** The Lab: its frame, the stage and the couplings. A [text|term] in brackets is a term with an explanation. */
export const words = {
  files,
  learn,
  loops,
  /** Names of parts as in the story, and titles of splits by their ids; the others are the library’s own. */
  partNames: { lower: "legs", upper: "arms" } as Readonly<Record<string, string>>,
  splits: { "lower-upper": "Legs and arms" } as Readonly<Record<string, string>>,
  title: "Coupled movement primitives",
  lab: "Lab",
  header: {
    files: "Files",
    open: "Open",
    openMeaning: "Open a model (.json), clips (.bvh) or tables (.csv)",
    help: "Help and keys",
    newVersion: "Load new version",
    newVersionMeaning: "A new version is there. Loading it begins anew: save first what you want to keep.",
  },
  page: {
    panels: { learn: "Learn", more: "More", numbers: "Numbers" },
    closePanel: "Close this panel",
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
    leaveLarge: "Leave the projector mode",
    leaveLargeKey: "Leave the projector mode (Escape)",
    drop: "Drop motion clips (.bvh), tables (.csv) or a model (.json)",
  },
  stage: {
    made: "Made by the model",
    lead: {
      drag: "Drag an arrow, or its α: do the parts keep step?",
      live: "Hold an arrow, or the key c, to cut a coupling. Drag the dot of a loop to push its part.",
      learning: "A model is learning: what it can do so far moves, and its loops form.",
      own: "Couplings of your own, not those that the model learned.",
      clip: "This is a clip: what a model learns from, not what it made.",
      hidden: "These loops and sliders belong to a motion that is hidden now: they do not move this figure.",
    },
    rollout: "A rollout",
    madeBy: (kind: string) => `Made by a ${kind}`,
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
    playSamples: "Play samples",
    samplesMeaning:
      "Samples draw each step from the spread of the prediction. Of three people they slid more than a person’s walks differ, and trembled more, too.",
    sampled: (seed: number) => ({
      title: `Made by the model: sample ${seed}`,
      text: "Each loop is another motion that the model could make",
    }),
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
    own: "Your own",
    /** Of the model that the page opens with, by id. */
    start: Object.fromEntries(
      startPresets.map(({ id, name }) => [id, { name, meaning: START_MEANINGS[id] ?? "" }]),
    ) as Record<string, PresetWords>,
    learned: { name: "As learned", meaning: "The parts as training coupled them." },
    alone: (part: string) => ({
      name: `${capital(part)} alone`,
      meaning: `What the other parts guess about ${part} hardly counts.`,
    }),
    follows: (part: string) => ({
      name: `${capital(part)} by the others alone`,
      meaning: `What ${part} would do next by the own past hardly counts.`,
    }),
  },
  couplings: {
    map: "Couplings",
    toOther: (source: string, target: string) => `${source} → ${target}`,
    arrow: "Drag up or down: thicker, thinner. Hold: cut",
    slidersOf: (part: string) => `Show what drives ${part}`,
    oneSlider: "The coupling with a slider",
    failed: "The model could not be started, so its couplings cannot be changed.",
    empty: "How the parts drive each other appears here.",
    onePart: "This model has one [part|part], so no part drives another. Train one with two parts or more.",
    completing: "Let a recording move one part",
    begins: "Where the motion begins",
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
    pair: (source: string, target: string) => `alpha from ${source} to ${target}`,
    tick: (alpha: string, trained: boolean) => `${trained ? "As learned" : "As it was"}: ${alpha}`,
    value: (alpha: string, weight: string, learned: string | null) =>
      `alpha ${alpha}, weight ${weight}${learned === null ? "" : `; learned ${learned}`}`,
    slider: (pair: string) => `${pair}: drag to change, double click to reset`,
    alphaMeaning: "alpha, the variance of this prediction: small means influential",
    weightMeaning: "weight of this prediction; the weights into a part sum to 1",
  },
  live: {
    hint: "Drag a limb or turn the wheel to move a part yourself.",
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
    cut: (source: string, target: string) => `${source} → ${target} is cut`,
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
    title: "[Experts|expert], when a coupling changes",
    label: "experts",
    about: "What do as learned and re-inferred mean?",
    text: { "re-inferred": "re-inferred", "as-learned": "as learned" },
    experts: (reading: string) => `Experts ${reading}`,
    meaning: {
      "re-inferred":
        "What all that the model learned from would have taught each part’s predictions under these couplings.",
      "as-learned": "Only the weights change: each part predicts as before, and counts for more or less.",
    },
    both: "Left, as learned: training made the experts as a team, and one left alone does only its share. Right, re-inferred: all that the model learned from, read again with these couplings; latents and kernels stay.",
    bothButton: "Both side by side",
    resetAll: "Reset",
  },
  measured: {
    compared: (reading: string) => `Measured${reading && ` ${reading}`}:`,
    since: (seconds: number) => `from ${number(seconds, 1)} s on`,
    still: (since: string) => `one pose ${since}`,
    pose: (since: string) => `keeps one pose ${since}`,
    common: (step: string) => `hands and feet ${step}`,
    swingsBy: (centimetres: number) => `${number(centimetres, 0)} cm far`,
    swings: (share: number, hardly: boolean) =>
      `${hardly ? "hardly any swing, " : ""}${number(share, 2)} × as far`,
    noPace: "without a steady pace",
    pace: (is: number, was: number) => `${number(is, 2)} s instead of ${number(was, 2)} s`,
    speed: (share: number) => `${number(share, 2)} × as fast`,
    step: { "in step": "in step", "partly in step": "partly in step", "out of step": "out of step" },
    aPart: "a part",
    standsStill: (since: string) => `stands still ${since}`,
    visits: (share: number, part: string) =>
      `visits ${Math.round(100 * share)} % of its clips’ poses in ${part}`,
    leaves: (part: string, since: string) => `outside the training range ${since}: ${part}`,
    shakes: (part: string | null, times: number | null, turnsBack: number) =>
      `shakes (${part ?? "the whole body"}): ${times === null ? "" : `${number(times, 1)} × as fast as in its clips, `}and ${Math.round(100 * turnsBack)} % of its steps turn back`,
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
    live: "live",
    liveMeaning: "The model goes on from here without an end: cut couplings and move parts while it moves",
    frame: "Frame",
    frameOf: (frame: number, count: number) => `Frame ${frame} of ${count}`,
    length: "Length of the motion in seconds",
    lengthMeaning: (least: string, most: string) => `How long the model goes on, ${least} to ${most} seconds`,
    loop: "Repeat the motion",
    speed: "Speed",
  },
};

export type LabWords = typeof words;
