// The sentence about a fit of couplings: its progress, its success, or why it found nothing.
import { LARGEST_COUPLING } from "../engine/limits";
import { sentence } from "../ui/format";
import type { FittingStore } from "./fitting-store";

type Fit = Pick<FittingStore, "busy" | "iteration" | "elapsed" | "ending" | "unexplained">;

export function fitText({ busy, iteration, elapsed, ending, unexplained }: Fit): {
  text: string;
  failed: boolean;
} {
  if (busy) return { text: `Iteration ${iteration}`, failed: false };
  const { words, failed } = ending;
  if (!words) return { text: "Learns the couplings alone; the primitives stay.", failed };
  if (failed) return { text: sentence(words), failed };
  const seconds = `${elapsed.toFixed(1)} s.`;
  if (unexplained.length === 0) return { text: `${sentence(words)} ${seconds}`, failed };
  const parts = unexplained.join(" and ");
  const text =
    `No coupling found for ${parts}: all predictions about ${parts} ended at the limit, α = ` +
    `${LARGEST_COUPLING}. These primitives do not explain ${parts} in this clip. Reset undoes the fit. ${seconds}`;
  return { text, failed: true };
}
