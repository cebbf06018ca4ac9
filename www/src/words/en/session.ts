const counted = (count: number, singular: string, plural: string) =>
  count === 1 ? singular : `${count} ${plural}`;
const listed = (words: readonly string[]) =>
  words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;

/** What earlier visits left, and "Forget everything". */
export const words = {
  clips: (count: number) => counted(count, "a clip", "clips"),
  runs: (count: number) => counted(count, "a training", "trainings"),
  models: (count: number) => counted(count, "a model", "models"),
  results: (count: number) => counted(count, "a comparison", "comparisons"),
  libraries: (count: number) => counted(count, "a library of primitives", "libraries"),
  listed,
  when: (at: Date | number) =>
    new Intl.DateTimeFormat("en", { dateStyle: "long", timeStyle: "short" }).format(at),
  /** `when`: null: unknown. */
  offer: (when: string | null, contents: string) =>
    `From ${when === null ? "an earlier visit" : `your visit of ${when}`}: ${contents}.`,
  notWhole: "The rest of it cannot be read.",
  taken: "Another tab has it.",
  bringBack: "Bring back",
  forgetVisit: "Forget",
  earlier: (count: number) => `Earlier visits: ${count} more`,
  unreadable: (count: number) =>
    `${count === 1 ? "An earlier visit" : `${count} earlier visits`} cannot be read: damaged, or of another version of this page.`,
  forget: "Forget everything",
  forgetTitle: "Forget everything?",
  undoable:
    "You can undo this until you leave or reload the page. Other open tabs, a participant who answers now, and the files on your disk stay as they are.",
  undo: "Undo",
  notForgotten: "Not all was forgotten",
  notBack: "Not all came back",
  /** The contents of this visit, and of this number of earlier visits. */
  ofVisits: (contents: string, earlier: number) =>
    earlier === 0
      ? contents
      : `${contents} (of this visit and ${counted(earlier, "an earlier one", "earlier ones")})`,
  allAnswers: "all answers of participants on this machine",
  answers: (answers: number, participants: number) =>
    `${counted(answers, "the answer", "answers")} of ${counted(participants, "a participant", "participants")} on this machine`,
  storesNothing:
    "This browser stores nothing of your visits yet. It then stores nothing of this visit either.",
  removes: (pieces: readonly string[]) =>
    `This removes ${pieces.join(", and ")} from this browser. It then stores nothing of this visit either.`,
  forgotten: (pieces: readonly string[]) =>
    `Forgotten${pieces.length === 0 ? "" : `: ${pieces.join(", and ")}`}. It comes back only with Undo, and only until you leave the page.`,
  notKept: "This visit cannot be kept",
  notKeptWhy: (why: string) =>
    `The browser does not store it: ${why}. Save what you want to have after closing or reloading the page.`,
  full: "its storage for this page is full",
  notBroughtBack: "The earlier visit could not be brought back",
  otherTab: "Another tab has brought it back or removed it.",
  notAllBroughtBack: "Not all of the earlier visit was brought back",
  trainingRuns: "A training is running: cancel it first, or bring the visit back when it is over.",
  keepsPresent: "You keep the work on this page.",
  theClip: (title: string) => `The clip ${title}`,
  theTrainings: "The trainings",
  theModel: "The model",
  theLibrary: "The library of primitives",
};

export type SessionWords = typeof words;
