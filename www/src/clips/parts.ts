// The parts of a skeleton: from a preset of the clip or from a split by hand.
import type { ClipInfo, JointInfo, PartSpec } from "../engine/protocol";
import { BY_HAND } from "../settings/settings";

/** The parts of a skeleton: the chosen preset, or its first preset when it has no such one. */
export function partsFor(
  clip: Pick<ClipInfo, "joints" | "presets">,
  chosen: string,
  split: PartSpec[],
): PartSpec[] {
  if (chosen === BY_HAND && split.length > 0) return completeSplit(clip.joints, split);
  const preset = clip.presets.find(({ id }) => id === chosen) ?? clip.presets[0];
  return preset?.parts ?? [];
}

/** A split with every joint once and without empty parts, which can be trained. */
export function completeSplit(joints: Pick<JointInfo, "parent">[], split: PartSpec[]): PartSpec[] {
  return filledSplit(joints, split).filter(({ joints: own }) => own.length > 0);
}

/** The same with empty parts. A missing joint gets the part of its parent, a missing root the first part. */
export function filledSplit(joints: Pick<JointInfo, "parent">[], split: PartSpec[]): PartSpec[] {
  const part = new Array<number>(joints.length).fill(-1);
  split.forEach(({ joints: own }, index) => {
    for (const joint of own) if (joint < joints.length) part[joint] = index;
  });
  joints.forEach(({ parent }, joint) => {
    if (part[joint] === -1) part[joint] = parent === null ? 0 : (part[parent] ?? 0);
  });
  return split.map(({ name }, index) => ({
    name,
    joints: part.flatMap((other, joint) => (other === index ? [joint] : [])),
  }));
}

/** Puts a joint and everything below it into a part. */
export function moveBranch(
  joints: Pick<JointInfo, "parent">[],
  split: PartSpec[],
  joint: number,
  to: number,
): PartSpec[] {
  const moved = new Set([joint]);
  joints.forEach(({ parent }, child) => {
    if (parent !== null && moved.has(parent)) moved.add(child);
  });
  return split.map(({ name, joints: own }, index) => {
    const remaining = own.filter((other) => !moved.has(other));
    return { name, joints: index === to ? [...remaining, ...moved].sort((a, b) => a - b) : remaining };
  });
}
