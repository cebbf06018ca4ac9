import { decimal } from "../../ui/decimal";

const metres = (value: number) => decimal("en", value, 2);
const centimetres = (value: number) => decimal("en", Math.abs(100 * value), 0);
const height = (value: number) => `${centimetres(value)} cm ${value < 0 ? "below" : "above"} the hips`;

export const borrow = {
  title: "Borrow arms",
  text:
    "A library keeps what each part of a body has learned: legs that walk or run, arms of a jumping jack, an " +
    "arm that waves. A piece like this is a movement primitive. The pieces were learned once, from recordings, " +
    "and can be put together in a new way. You see a walk that was learned as a whole. In a moment its legs " +
    "get the arms of a jumping jack. Nobody ever recorded that.",
  guess: {
    question: "What will the borrowed arms do?",
    choices: { own: "Their own movement", legs: "Swing as before", still: "Hardly move" },
  },
  opening: "Opening the library.",
  measuring: "Measuring the new movement.",
  movements: { walk: "walk", run: "run", jump: "jumping jack", wave: "wave" } as Readonly<
    Record<string, string>
  >,
  parts: { legs: "Legs", arms: "Arms" },
  never: "Never recorded.",
  recorded: (movement: string) => `Learned as a whole: ${movement}.`,
  hands: (is: number, speed: number) => `Hands on average: ${height(is)}, ${metres(speed)} m/s`,
  compared: (is: number, speed: number) => `; with their own legs: ${height(is)}, ${metres(speed)} m/s`,
  feet: (steps: number) =>
    steps > 0 ? `${decimal("en", steps, 1)} steps a second.` : "The body stays in its place.",
  outcome: {
    own: "The arms do their own movement.",
    legs: "The arms swing as before.",
    still: "The arms hardly move.",
  },
  wheel: (part: string) => `Wheel: moves the ${part} through their step. Arrow keys turn it, Escape lets go.`,
  wheelMeaning: "Drag the rim: one turn is one step cycle. Let go, and the model moves on.",
  figure:
    "A figure that moves on without an end. Drag a hand or a foot to pull it, drag elsewhere to look from another side; keys: w, a, s, d.",
};
