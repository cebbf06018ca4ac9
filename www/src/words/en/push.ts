import { decimal } from "../../ui/decimal";

const radii = (value: number) => decimal("en", value, value < 1 ? 2 : 1);
const seconds = (value: number) => `${decimal("en", value, 1)} s`;

export const push = {
  title: "Push it",
  text:
    "This walk follows no recording. The model guesses each pose from the last two poses, and its guesses " +
    "lead round and round a loop: one loop for the legs, one for the arms. Now we pull a hand, and the arms " +
    "leave their loop. From there, too, the model can only guess the next pose from the last two. It " +
    "does not know that anybody pulled.",
  guess: {
    question: "What will the walk do?",
    choices: { fall: "Fall over", stop: "Stop", back: "Come back" },
  },
  parts: ["legs", "arms"],
  walk: "Let it walk",
  pull: "Pull a hand",
  drag: "or drag one yourself",
  measuring: "Measuring the way home.",
  away: (part: string, farthest: number) =>
    `The ${part} left their loop by ${radii(farthest)} times its radius.`,
  home: (time: number) => `${seconds(time)} later all was on its loop again.`,
  lost: "It has not come home.",
  back: "Guess after guess, the path came back to the loop.",
  wheel: {
    youAre: "Be the legs",
    invites: "Be the legs: turn the wheel. The arms follow.",
    wheel: (part: string) =>
      `Wheel: moves the ${part} through their step. Arrow keys turn it, Escape lets go.`,
    wheelMeaning: "Drag the rim: one turn is one step cycle. Let go, and the model walks on.",
  },
  noFall: "It cannot fall: the model knows no weight.",
  equation: (order: number) => `The next state depends on the last ${order} states alone.`,
  figure:
    "A walking figure. Drag a hand or a foot to pull it, drag elsewhere to look from another side; keys: w, a, s, d, plus and minus.",
  loops: "The loop of the arms above, that of the legs below, each with a dot for the present pose.",
};
