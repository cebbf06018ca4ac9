// The movements of a study as motions that can be drawn.
import type { Motion } from "../engine/protocol";
import type { StudyInfo } from "../engine/whole-protocol";

/** The motion of each stimulus. `movements`: positions of the figure's nodes [frames x nodes x 3]. */
export function motionsOf(
  { skeleton, framesPerSecond }: StudyInfo,
  movements: readonly Float32Array[],
): (stimulus: number) => Motion {
  const nodes = skeleton.parents.length;
  return (stimulus) => {
    const positions = movements[stimulus] ?? new Float32Array(3 * nodes);
    return { positions, nodes, frames: positions.length / (3 * nodes), frameTime: 1 / framesPerSecond };
  };
}
