// Which part of the body each joint belongs to.
import type { PartSpec } from "../engine/protocol";

/** The part of each joint, -1 where no part has it [joints]. */
export function partOfJoints(count: number, parts: readonly PartSpec[]): Int16Array {
  const part = new Int16Array(count).fill(-1);
  parts.forEach(({ joints }, index) => {
    for (const joint of joints) if (joint < count) part[joint] = index;
  });
  return part;
}
