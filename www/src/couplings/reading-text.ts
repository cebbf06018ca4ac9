// The readings of changed couplings as the page writes them.
import type { Reading } from "../engine/protocol";

/** The place of a reading while both are side by side. */
const SIDE_TEXT: Record<Reading, string> = {
  "as-learned": "Left, as learned",
  "re-inferred": "Right, re-inferred",
};

/** A sentence about the motion in one reading; it names the figure if both readings are side by side. */
export function readingSentence(sentence: string, reading: Reading, bothShown: boolean): string {
  return bothShown
    ? `${SIDE_TEXT[reading]}: ${sentence.charAt(0).toLowerCase()}${sentence.slice(1)}`
    : sentence;
}

export const READING_TEXT: Record<Reading, string> = {
  "re-inferred": "re-inferred",
  "as-learned": "as learned",
};
