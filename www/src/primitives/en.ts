import { decimal } from "../ui/decimal";

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
export const words = {
  loading: "Loading",
  tryAgain: "Try again",
  notOpened: (why: string) => `The library could not be opened: ${why}`,
  notPutTogether: "These primitives could not be put together",
  doesNotMove: (title: string) => `${title} does not move`,
  areas: {
    library: "The library",
    figure: "The figure",
    chimera: "Chimera",
    couplings: "Couplings",
    imports: "Primitives of other files",
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
      "Models learned these movements from recordings. Open one here. Clips that it makes are in the list above: tick clips of one movement and train a model of your own on them.",
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
  },
  couplings: {
    title: "[Couplings|coupling]",
    reset: "Reset",
    about:
      "Right is strong. In a new combination the parts never met: their couplings begin at the weak limit, and only a part that hardly listens to itself still hears the other.",
    clip: "Clip",
    fit: "Fit to this clip",
    fitting: "Fitting",
    keep: "Add to the library",
    keepMeaning: "As a movement of the library, with these couplings",
    stage: "Put on the stage",
    stageMeaning: "As a model, with these couplings, in the Lab",
    cut: "cut",
    cutOf: (source: string, target: string) => `Cut ${source} → ${target} while held`,
    cutMeaning: "While held, this coupling is cut",
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
  imports: {
    add: "Add primitives",
    addMeaning: "Add the primitives of another file (.json) to this library",
    known: "These primitives are in the library already.",
    added: (names: string) => `Added ${names}.`,
  },
  learning: {
    title: "Learn a library",
    /** Around the words of two buttons. */
    about: (same: string, own: string) =>
      `Clips with the same name are one movement. A part that is the “${same}” has one primitive for all movements; with “${own}” it has one in each. Other settings are those of training, in the Lab, but the poses have the weight 1, there is one training, movements learn from their own rollouts, and a part has 12 points of each kind if no number was chosen.`,
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

export type PrimitivesWords = typeof words;
