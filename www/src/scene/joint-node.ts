// Where a joint is among the nodes of a figure, which also has the ends of the last bones.
import type { Figure } from "../engine/protocol";

/** The node of a joint; -1: the figure has none. */
export const nodeOfJoint = ({ nodes }: Figure, joint: number): number =>
  nodes.findIndex((node) => node.joint === joint && !node.endSite);

/** The node of the joint of this name; -1: the body has none. */
export const nodeNamed = (
  body: { joints: readonly string[]; figure: Figure } | null,
  name: string,
): number => (body ? nodeOfJoint(body.figure, body.joints.indexOf(name)) : -1);
