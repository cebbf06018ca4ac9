import { decimal } from "../decimal";

const number = (value: number, digits: number) => decimal("en", value, digits);

/** The movements of the page's library, and whose recordings they learned from. */
const MOVEMENTS: Readonly<Record<string, string>> = {
  walk: "Walk",
  run: "Run",
  jump: "Jumping jacks",
  wave: "Wave",
};
const PEOPLE: Readonly<Record<string, string>> = {
  walk: "CMU 35",
  run: "CMU 35",
  jump: "CMU",
  wave: "CMU 141",
};

/** The view Primitives. A [text|term] in brackets is a term with an explanation. */
export const primitives = {
  loading: "Loading",
  tryAgain: "Try again",
  notOpened: (why: string) => `The library could not be opened: ${why}`,
  notPutTogether: "These primitives could not be put together",
  doesNotMove: (title: string) => `${title} does not move`,
  stopped: "The figure has stopped",
  areas: {
    library: "The library",
    figure: "The figure",
    chimera: "Chimera",
    couplings: "Couplings and morph",
    imports: "Primitives of other files",
    experiment: "The experiment",
  },
  library: {
    made: "A library of recorded movements",
    learned: (movements: readonly string[], time: string) =>
      `It learned ${movements.map((name) => `“${name}”`).join(", ")} from ${time} of motion.`,
    source: "The recordings are not part of the page.",
    unsaved: "It is not saved yet.",
    undo: "Back to the library before",
    save: "Save the library",
    open: "Open a library",
    openMeaning: "Open a library of primitives (.json)",
    learnedHere: "The library learned here",
  },
  recorded: {
    about:
      "Models learned these movements from recordings. Open one here. Clips that it makes are in the list above: tick clips of one movement and train, and you get this walker again.",
    name: (movement: string) => MOVEMENTS[movement] ?? movement,
    modelMeaning: (movement: string) => `The model of “${movement}” on the stage`,
    clip: (movement: string, number: number) =>
      `${MOVEMENTS[movement] ?? movement} ${number}, by a model of ${PEOPLE[movement] ?? "a recording"}`,
    source: "The recordings are not part of the page.",
    where: "Get the recordings",
  },
  walk: {
    noGraphics: "This browser shows no 3-D graphics (WebGL), so only the small figures are drawn.",
    slots: (title: string) => `Slots: ${title}`,
    figure: (title: string) =>
      `A figure that goes on without an end: ${title}. Drag to look from another side; with the keyboard: w, a, s, d.`,
    never: "Never recorded",
    recordedAs: (name: string) => `Recorded as ${name}`,
  },
  drawer: {
    title: "Primitives",
    about: "What each part has learned to do. Press one, or drag it onto the body: the other parts go on.",
    of: (part: string) => `Primitives of ${part}`,
    relearned: "learned again",
    save: "Save",
    saveOf: (part: string, name: string) => `Save ${part}: ${name}`,
    saveMeaning: (origin: string) => `Save this primitive as a file. ${origin}`,
    notSaved: (part: string, name: string) => `${part}: ${name} was not saved`,
  },
  gallery: {
    title: "All combinations",
    never: "never recorded",
    recordedAs: (name: string) => `recorded as ${name}`,
    more: (count: number) => `${count} more do not fit here. Put them together on the body.`,
  },
  chimera: {
    title: "Chimera: two tempos in one body",
    about:
      "Let each part go through its own time slower or faster; 1 is as learned. The tempo is ours, not the papers’.",
    tempoOf: (part: string) => `Tempo of ${part}`,
    times: (tempo: number) => `${number(tempo, 2)} times as learned`,
    notYet: "not there yet",
    locking: (value: number) => `locking ${number(value, 2)}`,
    point: (tempo: number, strength: string, text: string) =>
      `Tempo ${number(tempo, 2)}, coupling × ${strength}: ${text}`,
    map: (target: string, source: string) =>
      `How firmly ${target} is locked to ${source}, for each tempo and strength. Arrow keys go from point to point.`,
    axes: (target: string, source: string, alpha: string) =>
      `Up: tempo of ${target}. To the right: how much stronger the coupling from ${source} to ${target} is than now; its α, ${alpha}, is divided by this. Colour: 1 where the difference of their phases never changes, 0 where it takes all values alike.`,
    ownWay: "goes its own way",
    inStep: "keeps in step",
    effects: (tempo: number, strength: number) =>
      `From tempo to tempo the locking differs by ${number(tempo, 2)} at most, from strength to strength by ${number(strength, 2)}.`,
    stripes: (effects: string) =>
      `Only stripes: the tempo makes little difference here, the coupling decides. ${effects}`,
    leads: "Leads",
    follows: "Follows",
    make: "Make the map",
    making: "The map",
    empty:
      "When does one part still keep step with the other? The map tries all tempos and strengths; press a point to see it walk.",
  },
  couplings: {
    title: "[Couplings|coupling]",
    reset: "Reset",
    about:
      "Right is strong. In a new combination the parts never met, so at first they hardly listen to each other.",
    clip: "Clip",
    fit: "Fit to this clip",
    fitting: "Fitting",
    keep: "Add to the library",
    keepMeaning: "As a movement of the library, with these couplings",
    stage: "Put on the stage",
    stageMeaning: "As a model, with these couplings, in the Lab",
    fitAbout: "Learns the couplings alone; the primitives stay.",
    fitted: (how: string, seconds: number) => `${how} ${number(seconds, 1)} s.`,
    unexplained: (parts: readonly string[], limit: number, seconds: number) => {
      const names = parts.join(" and ");
      return `No coupling found for ${names}: all predictions about ${names} ended at the limit, α = ${limit}. These primitives do not explain ${names} in this clip. Reset undoes the fit. ${number(seconds, 1)} s.`;
    },
    rests: {
      keepsPose: (part: string) => `one pose: ${part}`,
      alone: "alone it comes to rest",
      decides: (leader: string, share: number, part: string) =>
        `${Math.round(100 * share)} % of what comes next for ${part} is decided by ${leader}`,
      ownRest: "; with that, its own predictions come to rest",
      doesNotDrive: ", and does not drive it under these couplings",
      neverLearned: (leader: string, part: string) => `, and ${leader} never learned to drive ${part}`,
    },
  },
  morph: {
    title: "Morph",
    about: "Moves what a part predicts from one of its primitives to another, little by little.",
    fromTo: (part: string, from: string, to: string) => `${part}: from ${from} to ${to}`,
    share: (share: number, to: string) => `${Math.round(100 * share)} per cent ${to}`,
    towards: (part: string) => `${part}: towards`,
  },
  imports: {
    add: "Add primitives",
    addMeaning: "Add the primitives of another file (.json) to this library",
    of: (title: string) => `Primitives of ${title}`,
    misfit: (why: string) => `does not fit as it is: ${why}`,
    about:
      "Its primitives can be learned again here: their dynamics anew, while the pose maps and primitives of this library stay. What the file keeps of its movement shows what its own pose maps show of it; a clip shows all of it.",
    from: "From",
    kept: "what the file keeps",
    relearn: "Learn again",
    relearning: "Learning again",
    dismiss: "Leave it",
    busy: "Primitives are being learned again: wait for them, or cancel.",
    known: "These primitives are in the library already.",
    added: (names: string) => `Added ${names}.`,
    lost: (each: readonly (readonly [share: string, part: string])[]) =>
      `The pose maps of this library do not show ${each.map(([share, part]) => `${share} of ${part}`).join(" and ")}.`,
  },
  learning: {
    title: "Learn a library",
    /** Around the words of two buttons. */
    about: (same: string, own: string) =>
      `Clips with the same name are one movement. A part that is the “${same}” has one primitive for all movements; with “${own}” it has one in each. All other settings are those of training, in the Lab.`,
    same: "same",
    own: "own",
    learn: "Learn",
    going: "Learning",
    done: "Learned",
    hint: "It takes the place of the library above, which can be brought back.",
    from: (title: string) => `Learn from ${title}`,
    movement: (title: string) => `Movement of ${title}`,
    gettingReady: "Getting the sample clips ready.",
    two: "Choose clips of two movements.",
    another: "Choose clips of another movement too.",
  },
  recognition: {
    title: "Which movement is this?",
    about:
      "Each movement of the library follows each part of the recording and says how likely it is; so each part has its most likely primitive at each moment. The legs may walk while the arms do another movement. Choose clips, which are joined, or drop a recording of the same body here.",
    clip: "Clip",
    after: "then",
    nothing: "nothing",
    recognise: "Recognise",
    going: "Every movement follows the recording",
    tooFew: "The library has one movement only: there is nothing to choose from.",
    figure: "The recording",
    time: "Time",
    segment: (movement: string, first: string, end: string) => `${movement} from ${first} to ${end} s`,
  },
  lesson: {
    title: "Is a shared primitive as good as one of its own?",
    question:
      "Velychko et al. (2018, figure 7) let walking and walking with waving share one primitive of the lower body, and ask whether each movement is predicted as well as by a model of its own. Their answer: equal within the standard errors.",
    /** Around the command. */
    method: [
      "The same with the ten made trials of this project: one is held out, all others are trained on. Errors after time warping, times 1,000, with standard errors. Measured once, by",
      "; below, one trial can be held out in your browser.",
    ],
    errors: "A library compared with models of one movement",
    open: "The intervals of the differences hold 0: which is better stays open on ten made trials.",
    costs: "The cost of a library compared with models of one movement",
    paths: "Latent paths of the lower and the upper body, of walking and of walking with waving",
    caption: "The latent paths of a library: generated (solid) and as trained (dashed).",
    importTitle: "Primitives in another library",
    importText:
      "A primitive means nothing under the pose maps of another training: it is learned again there, from clips, from the latents that its file keeps, or from its own rollouts. Here walking moves into a library of walking with waving that has never seen a walk without it.",
    imports: "Walking learned again in another library",
    importFinding:
      "The legs lose nothing: the other library knows legs that walk. Most of how the arms of a walk are held is not among its poses, and what its pose maps do not show cannot come back, whatever the dynamics learn.",
    combinationTitle: "A combination that nobody recorded",
    combinationText:
      "Legs from walking, arms from waving while standing: the couplings are fitted to the first seconds of a recording of both, and every model predicts the same last three seconds. Means over eight sets of made trials; beside them the ratio to the first row with its 95 % interval, and in how many sets it is below 1.",
    combinations: "A combination of primitives compared with other models",
    combinationFinding:
      "With half a second seen, a model of that half second does not move at all and has the larger error in all eight sets; with one or two seconds, it is undecided which is better. Whether the couplings help is undecided too: these made arms do not listen to the legs.",
    /** Cells of the tables, which the program writes in English, in another language. */
    cells: {} as Record<string, string>,
    setUp: "Set the experiment up above",
    setUpMeaning: (learn: string) =>
      `All ten clips in two groups, the lower body the same: press “${learn}”, and watch which combinations walk.`,
  },
  fold: {
    title: "Hold a trial out here",
    about:
      "A library is trained on all other trials of both movements, and a model on those of the trial’s own movement; both also see its first five frames, and predict the rest. Of two seeds the one of the higher bound counts.",
    trial: "Trial",
    quick: "a tenth of the iterations, for a first look",
    start: "Hold it out",
    library: "Library of both movements.",
    alone: "Model of its movement alone.",
    over: "Over.",
    cancelled: "You cancelled: there is nothing to compare.",
    label: "One trial held out",
    heads: (title: string, trials: string) => [
      "DTW MSE × 1,000",
      `${title}, here`,
      `all ${trials} trials, measured`,
    ],
    rows: { alone: "alone", library: "library" },
    one: (folds: number) => `This is one fold of ${folds}: which model is better cannot be said from it.`,
    quickErrors: "With a tenth of the iterations the errors are not those of the table.",
    going: "A trial is held out",
    there: "The errors are there",
  },
  origin: {
    frames: {
      clips: "clips given here",
      remembered: "what its file kept of them",
      generated: "rollouts of them",
    },
    more: (first: string, count: number) => `${first} and ${count} more`,
    unnamed: "clips that are not named",
    how: (iterations: number, seed: number) => `${iterations} iterations, seed ${seed}.`,
    learned: (from: string, how: string) => `Learned from ${from}; ${how}`,
    relearned: (primitive: string, from: string, frames: string, how: string) =>
      `Learned again, after ${primitive} of another library, which learned from ${from}: from ${frames}; ${how}`,
  },
};

export type PrimitivesWords = typeof primitives;
