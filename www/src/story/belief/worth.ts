// What couplings are worth, measured on recorded walks: docs/comparison.md has the commands.
import type { Ratio } from "../../words/en/belief";

/** Without couplings : with them, on the training trials and on trials held out; means over six persons. */
export const WITHOUT_COUPLINGS: { training: Ratio; heldOut: Ratio } = {
  training: [1.99, 1.31, 3.04],
  heldOut: [1.82, 1.19, 2.77],
};

/** vCGPDM : rhythmic DMP, on 23 trials held out. */
export const TO_RHYTHMIC_DMP: Ratio = [1.07, 0.95, 1.28];
