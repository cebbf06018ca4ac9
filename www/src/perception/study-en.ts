// What participants read as long as nobody writes other texts. The library writes these English texts into a
// new study, and the study of the page has its own instructions; a test compares both.

export type StudyWords = Readonly<
  Record<"consent" | "instructions" | "question" | "pause" | "end", readonly string[]>
>;

const INSTRUCTIONS = {
  cross: "In every trial a cross appears first: please look at it. Then two figures move side by side. ",
  answer:
    "\n\nWhen they have ended, say on which side you saw the more natural movement: press the left or the right arrow key, or tap on that side. There is no time limit, but answer with your first impression. If you cannot tell, guess.",
};

/** The standard texts of each name. Other languages have the same ones in the same order. */
export const study: StudyWords = {
  consent: [
    "You will see pairs of short movements and say which of the two looks more natural to you.\n\nTaking part is voluntary. You can stop at any time without giving a reason. Your answers are kept on this computer and are not sent anywhere. No name, picture or sound of you is recorded.",
  ],
  instructions: [
    `${INSTRUCTIONS.cross}One movement comes from a recording, the other from a computer model.${INSTRUCTIONS.answer}`,
    `${INSTRUCTIONS.cross}One is the walker of this project, a computer program that walks by published curves of people's gait: it stands for the natural movement here, because the project comes without recordings. The other was made by a model that learned from that walker.${INSTRUCTIONS.answer}`,
  ],
  question: ["On which side did you perceive the more natural movement?"],
  pause: ["Time for a pause. Rest your eyes for a moment."],
  end: ["That was all. Thank you for taking part!"],
};
