// Whether the frames of two rollouts have the same times.
import type { RolloutRequest } from "../engine/protocol";

/** Whether two rollouts have the same start and the same length. */
export function sameTimes(a: RolloutRequest, b: RolloutRequest): boolean {
  return a.frames === b.frames && a.sequence === b.sequence && a.frame === b.frame;
}
