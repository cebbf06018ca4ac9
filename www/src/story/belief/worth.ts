// What couplings are worth, measured on recorded walks: docs/comparison.md has the commands.
import type { Ratio } from "../../words/en/belief";

/** Without couplings : with them, on the training trials and on trials held out of subject 7. */
export const WITHOUT_COUPLINGS: { training: Ratio; heldOut: Ratio } = {
  training: [1.67, 1.26, 1.99],
  heldOut: [1.4, 0.69, 2.83],
};

/** vCGPDM : rhythmic DMP, on 17 trials held out. */
export const TO_RHYTHMIC_DMP: Ratio = [0.99, 0.91, 1.19];
