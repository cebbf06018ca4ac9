import { decimal } from "../decimal";

const times = (value: number) => `${decimal("en", value, 2)} ×`;
const seconds = (value: number) => `${decimal("en", value, 2)} s`;

export const teach = {
  title: "For teachers",
  lead: "The chapters are slides, the page checks the exercises, and a class answers by short codes.",
  slides: {
    title: "Slides",
    start: "Start the slides",
    keys: {
      turn: ["← →", "the answer, then the next chapter; so does a clicker"],
      hands: ["1 2 3", "count a hand for this answer, Backspace takes it back"],
      notes: ["n", "your notes, in a second window"],
      code: ["q", "QR code of what is on the screen, in the Lab too"],
      end: ["Esc", "ends the slides"],
    },
  },
  plan: {
    title: "Plan",
    length: "Length of the lecture",
    minutes: (count: number) => `${count} minutes`,
    columns: ["Minutes", "Do", "Say", "What goes wrong"],
    do: {
      exercises: "Exercises, in pairs, in the Lab",
      compare: "Compare models",
      questions: "Questions of understanding",
    },
  },
  notes: {
    title: "Notes",
    blocked:
      "The browser has blocked the window with the notes. Allow windows of this page, then press n again.",
    next: (title: string) => `Next: ${title}`,
    say: "Say",
    wrong: "What goes wrong",
    hands: "Hands",
  },
  steps: {
    computer: {
      say: "One walk follows published curves, the other was learned from it. The papers asked people the same about recordings.",
      wrong: "The class looks for a flaw in one light: ask for the first impression.",
    },
    arms: {
      say: "Who is right depends on the question: what the data allow, or what the learned experts do.",
      wrong: "Everybody says “stop”: show the second way to cut, and ask why both are right.",
    },
    loop: {
      say: "Many angles, three numbers. Away from the loop the model has no data.",
      wrong: "The plane is read as a map of places: it is a map of poses.",
    },
    next: {
      say: "The model predicts one step and its variance; a motion is many steps.",
      wrong: "The fan is taken for an error: it is what the model does not know.",
    },
    points: {
      say: "The model keeps a few poses instead of all frames. The bound says what they cost.",
      wrong: "Fewest wins, but the walk on the stage must go on: let the class judge.",
    },
    product: {
      say: "Two predictions are multiplied; alpha is the variance that a circle shows. Only ratios count.",
      wrong: "The product is narrower than both: ask why before you say it.",
    },
    push: {
      say: "The rules lead back to the loop: a limit cycle. Nobody taught the model to come home.",
      wrong: "The figure is taken for a body with weight: it knows poses, not forces.",
    },
    borrow: {
      say: "Parts are modules: legs of a walk and other arms, never recorded together.",
      wrong: "The combination is taken for a cut between films: it is computed anew.",
    },
    belief: {
      say: "The truth is known here. On recordings it is not: then a model can only believe.",
      wrong: "A training needs some seconds: ask for reasons meanwhile.",
    },
    gaussian: {
      say: "One input, one output: mean, variance, and points to drag.",
      wrong: "The band is taken for the data’s noise: away from points it is what nobody knows.",
    },
    end: {
      say: "What is known, what nobody knows, and what one can make: let the class choose what to try.",
      wrong: "Nobody asks anything: ask which of the pictures surprised them.",
    },
    exercises: {
      say: "Give out the sheet or the QR codes. The page says when an exercise is solved.",
      wrong: "A changed coupling stays: Reset before the next exercise.",
    },
    compare: {
      say: "Simple models foresee a held-out walk as well. The coupled model adds parts that can be cut, pushed and exchanged.",
      wrong: "A comparison takes minutes: start it before the break, or show the recorded results.",
    },
    questions: {
      say: "Ten questions and answers are in docs/teaching.md.",
      wrong: "",
    },
  },
  exercises: {
    title: "Exercises",
    lead: "Each opens the Lab, where the page measures the figure and says when it is solved.",
    print: "Print the sheet",
    try: "Try it",
    code: "QR code",
    number: (number: number) => `Exercise ${number}`,
    why: "Why?",
    tasks: {
      pace: "Let the arms find a pace of their own, with the hands swinging at least half as far as learned.",
      pose: "Let the legs walk on while the arms keep one pose.",
      ratio: "Change two couplings by a factor of 2 or more each. The motion stays exactly as learned.",
      idle: "Change one coupling a hundredfold or more. Hands and feet move as before, within 5 %.",
      halt: "Stop the whole body by one changed coupling.",
      few: "Train a model of the sample walks with at most 6 points for the dynamics of each part. It walks on.",
    },
    whys: {
      pace: "Which arrow did you make thin, and who speaks about the arms now?",
      pose: "Why does the same arrow let the arms swing when the experts are inferred again?",
      ratio: "What do the two factors have in common?",
      idle: "What does this say about who explains whom in this walk?",
      halt: "Whose prediction about the next step got lost?",
      few: "What would the other points have been for?",
    },
    solved: "Solved.",
    notYet: "Not yet.",
    measuring: "Measuring.",
    close: "Close the exercise",
    found: {
      parts: (legs: number, arms: number) =>
        `Swing of the feet ${times(legs)} as learned, of the hands ${times(arms)}.`,
      pace: (legs: number, arms: number) => `Legs ${seconds(legs)}, arms ${seconds(arms)} for a swing.`,
      inStep: (locking: number) => `In step: ${decimal("en", locking, 2)} of 1.`,
      apart: (millimetres: number) =>
        `At most ${decimal("en", millimetres, 1)} mm from the motion as learned.`,
      factors: (list: string) => (list ? `Changed: ${list}.` : "No coupling is changed."),
      model: (points: number) => `This model has ${points} points for a part.`,
      ownModel: "Train a model first.",
      startModel: "For this exercise open the model that the page opens with.",
      moves: "It moves on.",
      stands: "It does not move on.",
    },
  },
  codes: {
    title: "A class of the perception test",
    text: "Each student answers the short test on their own device and reads out a code. Paste the codes, one in each line, below the answers of the test.",
    open: "Open the test",
  },
  code: {
    title: "Share",
    copy: "Copy the link",
    copied: "Copied.",
    notCopied: "The browser does not allow it: copy it by hand.",
    close: "Close",
    local: "This address works on this machine only. Put the page on a web space for a class.",
  },
};

export type TeachWords = typeof teach;
