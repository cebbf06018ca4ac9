import { decimal } from "../decimal";

const metres = (value: number) => decimal("en", value, 2);
const centimetres = (value: number) => decimal("en", Math.abs(100 * value), 0);
const height = (value: number) => `${centimetres(value)} cm ${value < 0 ? "below" : "above"} the hips`;

export const borrow = {
  title: "Borrow arms",
  text:
    "A library keeps what each part of a body has learned: legs that walk, arms that swing, arms that " +
    "wave. A piece like this is a movement primitive. The pieces were learned once, and can be put together " +
    "in a new way. You see a movement that was learned as a whole, from clips that a program made. In a " +
    "moment these legs get the arms of another movement, which they never met.",
  guess: {
    question: "What will the borrowed arms do?",
    choices: { own: "Their own movement", legs: "Swing as before", still: "Hardly move" },
  },
  opening: "Opening the library.",
  measuring: "Measuring the new movement.",
  movements: { walk: "walk", wave: "wave", run: "run", jump: "jump" } as Readonly<Record<string, string>>,
  parts: { legs: "Legs", arms: "Arms" },
  never: "No clip shows this.",
  recorded: (movement: string) => `Learned as a whole: ${movement}.`,
  hands: (is: number, speed: number) =>
    `The hands are ${height(is)} on average and move at ${metres(speed)} m/s.`,
  compared: (movement: string, is: number, speed: number) =>
    `With the legs of their own ${movement}: ${height(is)}, ${metres(speed)} m/s.`,
  feet: (steps: number) => `The feet make ${decimal("en", steps, 1)} steps a second.`,
  outcome: {
    own: "The arms do their own movement.",
    legs: "The arms swing as before.",
    still: "The arms hardly move.",
  },
  figure: "A figure that moves on without an end. Drag to look from another side; keys: w, a, s, d.",
};
