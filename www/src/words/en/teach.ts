import { decimal } from "../../ui/decimal";

const times = (value: number) => `${decimal("en", value, 2)} ×`;
const seconds = (value: number) => `${decimal("en", value, 2)} s`;

export const words = {
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
    answer: "Answer",
    asked: "What they may ask",
    minutes: (from: number, to: number) => `Minutes ${from}–${to}`,
    hands: "Hands",
  },
  steps: {
    hand: {
      say: "You drew it, and something else goes on: a rule for the next moment, learned from a few seconds. That is a movement primitive.",
      wrong: "Only a dot, or half a round: draw three rounds without a rest.",
      asked: [
        [
          "Does it repeat what I drew?",
          "No: it keeps a few points of a rule and takes each step from the two before. So it can go on for ever, and err.",
        ],
        ["Why a loop?", "What returns to itself is a loop. The model keeps a moment of it in two numbers."],
      ],
    },
    arms: {
      say: "Who is right depends on the question: what the data allow, or what the learned experts do.",
      wrong: "Everybody says “stop”: show the second way to cut, and ask why both are right.",
      answer:
        "In this model, which was chosen for it: inferred again, the arms find a pace of their own. As learned, they stop.",
      asked: [
        [
          "Which of the two is right?",
          "Both: one asks what the clips allow without the legs, the other what the learned rule does alone.",
        ],
        [
          "What is the thread, really?",
          "One number, alpha from legs to arms: the variance of what the legs guess about the arms.",
        ],
      ],
    },
    loop: {
      say: "Many angles, three numbers. Away from the loop the model has no data.",
      wrong: "The plane is read as a map of places: it is a map of poses.",
      answer: "It fades: off the loop the model’s doubt grows, far away to that of a model without data.",
      asked: [
        [
          "Why three numbers?",
          "Joint angles move together in a walk, so a few numbers hold a pose. How many is a setting in the Lab: try two.",
        ],
        ["Does the loop close exactly?", "Nearly: each step is a guess, and the guesses lead back."],
      ],
    },
    next: {
      say: "The model predicts one step and its variance; a motion is many steps.",
      wrong: "The fan is taken for an error: it is what the model does not know.",
      answer:
        "It depends on the pin. The mean of the futures is the best guess, and single futures leave it.",
      asked: [
        [
          "Why is the circle small and the fan wide?",
          "The circle is one step. Uncertainty adds up from step to step.",
        ],
        [
          "Why does the path come back to the loop?",
          "The recorded steps lie along it, and the guesses lead to them.",
        ],
      ],
    },
    points: {
      say: "The model keeps a few poses instead of all frames. The bound says what they cost.",
      wrong: "Fewest wins, but the walk on the stage must go on: let the class judge.",
      answer: "On the way of the page about half, 12 of 24. Well chosen, six can walk.",
      asked: [
        [
          "Why not keep all frames?",
          "The work grows with the points, and what lies between them can be computed.",
        ],
        ["Where do the points lie?", "Where training put them: they move until the bound stops rising."],
      ],
    },
    product: {
      say: "Two predictions are multiplied; alpha is the variance that a circle shows. Only ratios count.",
      wrong: "The product is narrower than both: ask why before you say it.",
      answer: "Exactly as before: only ratios of the alphas move the step.",
      asked: [
        [
          "Why do the legs guess there?",
          "Both experts learned together. The legs’ part only has to pull the product the right way.",
        ],
        [
          "Multiplied or averaged?",
          "Multiplied. For bells of one width in all directions the mean of the product is a weighted mean, and its variance is smaller than each.",
        ],
      ],
    },
    push: {
      say: "The rules lead back to the loop: a limit cycle. Nobody taught the model to come home.",
      wrong: "The figure is taken for a body with weight: it knows poses, not forces.",
      answer: "It comes back; the card says after how many seconds.",
      asked: [
        [
          "Did anybody teach it that?",
          "No. The recorded steps lie round the loop, and the rules of this model lead back to it. Other models come to rest.",
        ],
        ["Could it fall?", "No: the model knows poses, and no weight and no ground."],
      ],
    },
    borrow: {
      say: "Parts are modules: legs of a walk and other arms, never recorded together.",
      wrong: "The combination is taken for a cut between films: it is computed anew.",
      answer: "The arms do their own movement.",
      asked: [
        [
          "Is that film editing?",
          "No: each pose is computed from the last ones. Here the new neighbours hardly hear each other: they never met.",
        ],
        [
          "Does every combination work?",
          "No. Some parts come to rest, because they never learned to drive each other.",
        ],
      ],
    },
    belief: {
      say: "The truth is known here. On recordings it is not: then a model can only believe.",
      wrong: "A training needs some seconds: ask for reasons meanwhile.",
      answer:
        "The curtain tells. docs/synthetic.md counts how often a model is right, by a stricter rule than this card.",
      asked: [
        [
          "Why not test this on the walk?",
          "There the truth is not known: a model says only what explains the recording.",
        ],
        ["What does neither look like?", "Both alphas between the points are large: no say."],
      ],
    },
    gaussian: {
      say: "One input, one output: mean, variance, and points to drag.",
      wrong: "The band is taken for the data’s noise: away from points it is what nobody knows.",
      answer: "Zero, and a wide band: the process says that it does not know.",
      asked: [
        ["Why zero?", "It was chosen before any data. In the model of a walk it is the mean of all poses."],
        ["Why is the band narrow at the points?", "A point tells the value there, up to noise."],
      ],
    },
    end: {
      say: "The card sums up rules, loops and couplings. Let the class choose what to try in the Lab.",
      wrong: "Nobody asks anything: ask which of the pictures surprised them.",
      asked: [
        ["What should I try first?", "Drag legs → arms to the left in the Lab, and see the arms’ loop."],
      ],
    },
    exercises: {
      say: "Give out the sheet or the QR codes. The page says when an exercise is solved.",
      wrong: "A changed coupling stays: Reset before the next exercise.",
    },
    compare: {
      say: "We did not find that the coupled model, trained as in the papers, foresees a held-out walk better than two simple ones, the TMP and the rhythmic DMP. It adds parts that can be cut, pushed and exchanged.",
      wrong: "A comparison takes minutes: start it before the break, or show the recorded results.",
    },
    questions: {
      say: "Ten questions: a listener answers them from what was on the screen.",
      wrong: "",
      asked: [
        [
          "What does the model learn from a recording: poses, or rules for the next pose?",
          "Rules: from the last states of a part it predicts the next one. The motion on the page was never recorded.",
        ],
        [
          "A body has many joint angles. Why are three numbers for each part enough to walk?",
          "In a walk the angles move together: the states lie near a closed curve in a space of few dimensions.",
        ],
        [
          "What happens to the figure when its state leaves the learned curve, and why?",
          "The model has never seen these points: its doubt grows, far away to that of a model without data, and the figure fades.",
        ],
        [
          "A Gaussian process gives two things for each prediction. Which?",
          "A mean and a variance: the next state, and how sure the model is.",
        ],
        [
          "The model is one step long. How does it make a motion of ten seconds?",
          "Each predicted state is the input of the next prediction: a rollout.",
        ],
        [
          "What is an inducing point, and why are a few of them enough?",
          "A point where the function is known. The model keeps these instead of all frames: a smooth function needs no more.",
        ],
        [
          "Two parts predict the next state of the arms. How do the two predictions become one?",
          "They are multiplied: the mean lies between, nearer to the one with the smaller variance alpha.",
        ],
        [
          "What is the coupling alpha from legs to arms, and what does a large alpha do?",
          "A variance: the larger it is, the less the arms listen to the legs.",
        ],
        [
          "Without the coupling, do the arms stop?",
          "Both answers are right for a question each, in this model, which was chosen for it: re-inferred they keep swinging at a pace of their own, as learned they keep one pose.",
        ],
        [
          "The model shows that a coupling exists. Does this show that the legs drive the arms of the person?",
          "No. It shows what explains the recordings. Data made with a known driver show how often the model finds the driver.",
        ],
      ],
    },
  },
  exercises: {
    title: "Exercises",
    lead: "Each opens a page that measures the motion and says when it is solved.",
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
      halt: "Let the whole body keep one pose by one changed coupling.",
      few: "Train a model of the sample walks with at most 6 points for the dynamics of each part. It walks on.",
      hands:
        "Draw two circles at two tempos, one with each hand. Stop one hand with one arrow; the other draws on.",
    },
    solutions: {
      pace: "re-inferred, legs → arms all the way to the left.",
      pose: "as learned, legs → arms all the way to the left.",
      ratio:
        "as learned, legs → arms and arms → arms by the same number of keys: only the ratio of the couplings into one part counts.",
      idle: "re-inferred, arms → legs all the way to the left: the legs’ own past explains the legs.",
      halt: "as learned, legs → legs all the way to the left: the legs then hear only the arms, which learned nothing about legs.",
      few: "the link sets 6 points; press Train.",
      hands:
        "as learned, left → left all the way to the left: the left hand then hears only the right one, which learned nothing about it.",
    },
    whys: {
      pace: "Which arrow did you make thin, and who speaks about the arms now?",
      pose: "Why does the same arrow let the arms swing when the experts are inferred again?",
      ratio: "What do the two factors have in common?",
      idle: "What does this say about who explains whom in this walk?",
      halt: "Whose prediction about the next step got lost?",
      few: "What would the other points have been for?",
      hands: "Why does the other hand draw on?",
    },
    dares: {
      title: "A dare",
      none: "no dare",
      tasks: {
        pose: "Stop the arms with one arrow. The legs must walk on.",
        pace: "Let the arms swing at a pace of their own.",
        hand: "Stop one hand with one arrow. The other hand must draw on.",
      },
      line: "A line to send along",
      met: "You have met the dare.",
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
      reading: "With re-inferred experts the rules change too: choose as learned.",
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

export type TeachWords = typeof words;
