// Where a joint is among the nodes of a figure, which also has the ends of the last bones.
import type { Figure, PartSpec } from "../engine/protocol";

/** The node of a joint; -1: the figure has none. */
export const nodeOfJoint = ({ nodes }: Figure, joint: number): number =>
  nodes.findIndex((node) => node.joint === joint && !node.endSite);

/** The node of the joint of this name; -1: the body has none. */
export const nodeNamed = (
  body: { joints: readonly string[]; figure: Figure } | null,
  name: string,
): number => (body ? nodeOfJoint(body.figure, body.joints.indexOf(name)) : -1);

/** The part of each joint, -1 where no part has it [joints]. */
export function partOfJoints(count: number, parts: readonly PartSpec[]): Int16Array {
  const part = new Int16Array(count).fill(-1);
  parts.forEach(({ joints }, index) => {
    for (const joint of joints) if (joint < count) part[joint] = index;
  });
  return part;
}
