import { decimal } from "../../ui/decimal";

const seconds = (value: number) => `${decimal("en", value, 2)} s`;
const centimetres = (value: number) => `${decimal("en", 100 * value, 0)} cm`;

export const arms = {
  title: "Who tells the arms when to swing?",
  text:
    "This walk was never recorded: another model makes it, step by step. Its legs and its arms each run round " +
    "a loop of their own. A thin thread keeps them together: what the legs say about where the arms go " +
    "next. Nobody told the model to tie it; it learned that from three recorded walks of one person. Now we cut " +
    "the thread.",
  guess: {
    question: "What will the arms do?",
    choices: { stop: "Stop", step: "Go on in step", pace: "Find a pace of their own" },
  },
  parts: ["legs", "arms"],
  thread: { label: "The thread", tied: "Tied", relearned: "Cut", kept: "Cut, as learned" },
  measuring: "Measuring 20 seconds of this walk.",
  periods: (legs: number, arms: number) =>
    `Legs ${seconds(legs)}, arms ${seconds(arms)} for a swing there and back.`,
  swing: (is: number, was: number) => `The hands swing ${centimetres(is)} instead of ${centimetres(was)}.`,
  tied: "They keep step, because the arms hear the legs.",
  outcome: {
    stop: "The arms stop.",
    step: "The arms go on in step.",
    pace: "The arms find a pace of their own.",
  },
  relearned: "Their rule has read its three walks again, now without the legs.",
  kept: "Who said “stop” is right too: here the arms keep what they learned next to the legs, and alone that is no swing.",
  equation: (tied: number, cut: number) =>
    `α is how unsure a source is about a part; w is its share in the step. The legs’ share in the arms: ` +
    `${decimal("en", 100 * tied, 0)} % tied, ${decimal("en", 100 * cut, 0)} % cut.`,
  clock: "Phase clock: one hand for the legs and one for the arms. Each turns once in a swing.",
  figure:
    "A walking figure. Drag to look from another side, scroll to come closer; keys: w, a, s, d, plus and minus.",
  walk: "Let it walk",
};
