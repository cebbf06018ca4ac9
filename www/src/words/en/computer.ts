import { decimal } from "../decimal";

export const computer = {
  title: "Which one learned to walk?",
  text:
    "Two walks, as points of light. One is a program: it walks by curves of people’s gait that scientists " +
    "have published. The other is a model: it watched three walks of that program, not this one, and now makes " +
    "each step by itself.",
  guess: { question: "Which one is the model?", choices: { left: "Left", right: "Right" } },
  names: { program: "the program", model: "the model" },
  play: "Let them walk",
  next: "Next pair",
  again: "Once more",
  right: { left: "Yes, the left one is the model.", right: "Yes, the right one is the model." },
  wrong: { left: "No, the left one is the model.", right: "No, the right one is the model." },
  apart: (metres: number) =>
    `Pose by pose, its lights are ${decimal("en", 100 * metres, 1)} cm from the program’s nearest pose, on average.`,
  score: (found: number, asked: number) =>
    `You found ${found} of ${asked}. Guessing alone finds about half of them.`,
};
