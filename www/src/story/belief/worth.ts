// What couplings are worth, measured on recordings: docs/comparison.md has the commands. Each is the median of
// the ratios of two errors, and the ends of its interval.

/** Without couplings : with them, on the training trials and on trials held out. */
export const WITHOUT_COUPLINGS = { training: [1.67, 1.26, 1.99], heldOut: [1.4, 0.69, 2.83] } as const;

/** vCGPDM : rhythmic DMP, on trials held out. */
export const TO_RHYTHMIC_DMP = [1.24, 1.11, 1.51] as const;
