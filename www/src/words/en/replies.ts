import type { Words } from "../en";

type Chapters = Words["chapters"];
/** A reply to each answer; chapters that keep a score, or ask for a pin, have none. */
type Answers = {
  readonly [Name in Exclude<keyof Chapters, "hand" | "next" | "belief" | "end">]: Readonly<
    Record<keyof Chapters[Name]["guess"]["choices"], string>
  >;
};

export interface Replies extends Answers {
  /** The rest of the last card. */
  readonly end: {
    readonly unknown: string;
    readonly doors: Readonly<Record<"draw" | "lab" | "own" | "primitives", string>>;
  };
}

export const words: Replies = {
  arms: {
    stop: "Right if the arms keep what they learned. Press “Cut” for arms whose rule is read again without the legs.",
    step: "No: without the thread nobody tells the arms when. Look at the clock: its hands drift apart.",
    pace: "Right.",
  },
  loop: {
    walk: "No: the model is less sure of the pose here. Where the next step leads is another rule, on card 5.",
    stop: "No: the model is less sure of the pose here. Where the next step leads is another rule, on card 5.",
    dissolve: "Right.",
  },
  gaussian: {
    on: "No: that far away the points say nothing. The dashed line is what you said.",
    prior: "Right.",
    nothing: "Nearly: it says how little it knows.",
  },
  points: {
    most: "No: between two points the model computes.",
    half: "Right, on the way of the page.",
    few: "Right for a good choice: six can walk. The way of the page needs about half.",
  },
  product: {
    more: "No: both are less sure, and their shares stay. The outline is the walk before: both are one.",
    same: "Right.",
    less: "No: both are less sure, and their shares stay. The outline is the walk before: both are one.",
  },
  push: {
    fall: "No: for falling one needs weight.",
    stop: "No: from there, too, each guess leads on.",
    back: "Right.",
  },
  borrow: {
    own: "Right.",
    legs: "No: these arms never learned from these legs.",
    still: "No: look at the hands.",
  },
  end: {
    unknown:
      "Nobody knows who really drives whom in a recorded walk. When people will call a new movement natural is known only in part. And to foresee a walk alone, we did not find this model, trained as in the papers, better than two far simpler ones, the TMP and the rhythmic DMP.",
    doors: {
      draw: "Couple your two hands",
      lab: "Drag the couplings",
      own: "Train your own movement",
      primitives: "Mix movements",
    },
  },
};
