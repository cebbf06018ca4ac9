// The strength of a coupling: the value of its slider. A smaller variance is further to the right.
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";

export const WEAKEST = -Math.log10(ALPHA_MAX);
export const STRONGEST = -Math.log10(ALPHA_MIN);

/** The slider's value for a coupling variance. */
export function strengthOf(alpha: number): number {
  return Math.min(STRONGEST, Math.max(WEAKEST, -Math.log10(alpha)));
}

/** The coupling variance for a slider's value. */
export function alphaOf(strength: number): number {
  return 10 ** -strength;
}

/** The place of a coupling on its slider: 0 at the left, weak end, 1 at the right, strong end. */
export function placeOf(alpha: number): number {
  return (strengthOf(alpha) - WEAKEST) / (STRONGEST - WEAKEST);
}
