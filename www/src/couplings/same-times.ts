// When the frames of two rollouts are those of the same times.
import type { RolloutRequest } from "../engine/protocol";

/** Whether two rollouts begin alike and are equally long. */
export function sameTimes(a: RolloutRequest, b: RolloutRequest): boolean {
  return a.frames === b.frames && a.sequence === b.sequence && a.frame === b.frame;
}
