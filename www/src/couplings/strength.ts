// How strong a coupling is: the value of its slider. The smaller its variance, the further right its thumb.
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

/** Where on its slider a coupling lies: 0 at the left, weak end, 1 at the right, strong end. */
export function placeOf(alpha: number): number {
  return (strengthOf(alpha) - WEAKEST) / (STRONGEST - WEAKEST);
}
