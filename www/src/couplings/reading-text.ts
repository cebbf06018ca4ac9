// The readings of changed couplings as the page writes them.
import type { Reading } from "../engine/protocol";

export const READING_TEXT: Record<Reading, string> = {
  "re-inferred": "re-inferred",
  "as-learned": "as learned",
};
