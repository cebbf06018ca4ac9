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
    stop: "Right for another question: press “Cut, as learned”.",
    step: "No: without the thread nobody tells the arms when.",
    pace: "Right.",
  },
  loop: {
    walk: "No: nothing here says which steps those would be.",
    stop: "No: for that, the model would have to know a pose here.",
    dissolve: "Right.",
  },
  gaussian: {
    on: "No: that far away the points say nothing.",
    prior: "Right.",
    nothing: "Nearly: it says how little it knows.",
  },
  points: {
    most: "No: between two points the model computes.",
    half: "Fewer will do.",
    few: "Right.",
  },
  product: {
    more: "No: both are less sure, and their shares stay.",
    same: "Right.",
    less: "No: both are less sure, and their shares stay.",
  },
  push: {
    fall: "No: for falling one needs weight.",
    stop: "No: from there, too, each guess leads on.",
    back: "Right.",
  },
  borrow: {
    own: "Right.",
    legs: "No: that swing belonged to the other arms.",
    still: "No: look at the hands.",
  },
  end: {
    unknown:
      "What nobody knows: who really drives whom in a recorded walk, and when people will call a new movement natural.",
    doors: {
      draw: "Couple your two hands",
      lab: "Drag the couplings",
      own: "Train your own movement",
      primitives: "Mix movements",
    },
  },
};
