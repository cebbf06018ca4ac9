// The readings of changed couplings as the page writes them.
import type { Reading } from "../engine/protocol";
import { lab } from "../words/lab";

/** A sentence about the motion in one reading; it names the figure if both readings are side by side. */
export function readingSentence(sentence: string, reading: Reading, bothShown: boolean): string {
  return bothShown
    ? `${lab().readings.side[reading]}: ${sentence.charAt(0).toLowerCase()}${sentence.slice(1)}`
    : sentence;
}

export const readingText = (reading: Reading): string => lab().readings.text[reading];
