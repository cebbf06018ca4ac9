// Whether the frames of two rollouts have the same times.
import type { RolloutRequest } from "../engine/protocol";

/** Whether two rollouts have the same start and the same length. */
export function sameTimes(a: RolloutRequest, b: RolloutRequest): boolean {
  const times = ({ frames, sequence, frame, start }: RolloutRequest) =>
    JSON.stringify([frames, sequence, frame, start]);
  return times(a) === times(b);
}
