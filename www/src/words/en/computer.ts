import { decimal } from "../decimal";

export const computer = {
  title: "Which one is a computer?",
  text:
    "Honestly: both. One is a program that walks by published curves of people’s gait. The other is a " +
    "model: it watched three walks of that program, but not this one, and now walks by itself. You see " +
    "points of light only.",
  guess: { question: "Which one is the model?", choices: { left: "Left", right: "Right" } },
  names: { program: "the program", model: "the model" },
  play: "Let them walk",
  next: "Next pair",
  again: "Once more",
  right: { left: "Yes, the left one is the model.", right: "Yes, the right one is the model." },
  wrong: { left: "No, the left one is the model.", right: "No, the right one is the model." },
  apart: (metres: number) =>
    `Its lights are ${decimal("en", 100 * metres, 1)} cm from the program’s, on average.`,
  score: (found: number, asked: number) =>
    `You found ${found} of ${asked}. Guessing alone finds about half of them.`,
};
