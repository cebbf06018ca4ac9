// The readings of changed couplings as the page writes them.
import type { Reading } from "../engine/protocol";
import { lab } from "../words/lab";

export const readingText = (reading: Reading): string => lab().readings.text[reading];
