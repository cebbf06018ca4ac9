// The sentence about a fit of couplings: its progress, its success, or why it found nothing.
import { LARGEST_COUPLING } from "../engine/limits";
import { sentence } from "../ui/format";
import type { FittingStore } from "./fitting-store";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "../words/primitives";

type Fit = Pick<FittingStore, "busy" | "iteration" | "elapsed" | "ending" | "unexplained">;

export function fitText({ busy, iteration, elapsed, ending, unexplained }: Fit): {
  text: string;
  failed: boolean;
} {
  const texts = primitivesWords().couplings;
  if (busy) return { text: lab().learn.training.iteration(iteration), failed: false };
  const { words, failed } = ending;
  if (!words) return { text: texts.fitAbout, failed };
  if (failed) return { text: sentence(words), failed };
  if (unexplained.length === 0) return { text: texts.fitted(sentence(words), elapsed), failed };
  return { text: texts.unexplained(unexplained.map(shownPart), LARGEST_COUPLING, elapsed), failed: true };
}
