// The movements of a study as motions that can be drawn.
import type { Motion } from "../engine/protocol";
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";

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

/** The heading of both: sideways and a little towards the observer. */
const HEADING = 60;

/** A generated movement and the natural one of its trial, or else the first natural one. */
export function pairOf({ stimuli }: StudyInfo, id: string): StudyTrial | null {
  const right = stimuli.findIndex((stimulus) => stimulus.id === id);
  const natural = stimuli.flatMap(({ kind, trial }, place) => (kind === "natural" ? [{ trial, place }] : []));
  const left = (natural.find(({ trial }) => trial === stimuli[right]?.trial) ?? natural[0])?.place;
  if (right < 0 || left === undefined) return null;
  return { block: 0, kind: "comparison", left, right, naturalSide: "left", headingDegrees: HEADING };
}
