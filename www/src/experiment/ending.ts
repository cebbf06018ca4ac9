// How a training of an experiment ended. The story, which has other words, does not use this file.
import { endingWords } from "../training/words";
import type { ExperimentRun } from "./experiments";

/** Empty before the end. */
export const endingOf = ({ outcome, ending }: ExperimentRun): string =>
  outcome ? endingWords(outcome) : ending;
