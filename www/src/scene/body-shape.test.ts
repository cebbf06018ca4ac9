import { describe, expect, it } from "vitest";
import { shapeOf } from "./body-shape";

function body(
  names: [string, number | null, [number, number, number]][],
  end?: [number, [number, number, number]],
) {
  const nodes = names.map(([, parent], joint) => ({ joint, parent, endSite: false }));
  const at: number[][] = [];
  for (const [, parent, offset] of names)
    at.push(offset.map((value, k) => value + (parent === null ? 0 : at[parent]![k]!)));
  if (end) {
    nodes.push({ joint: end[0], parent: end[0], endSite: true });
    at.push(end[1].map((value, k) => value + at[end[0]]![k]!));
  }
  return { figure: { nodes }, joints: names.map(([name]) => name), pose: new Float32Array(at.flat()) };
}

const person = body(
  [
    ["Hips", null, [0, 1, 0]],
    ["LeftUpLeg", 0, [0.1, 0, 0]],
    ["LeftLeg", 1, [0, -0.4, 0]],
    ["RightUpLeg", 0, [-0.1, 0, 0]],
    ["RightLeg", 3, [0, -0.4, 0]],
    ["Spine", 0, [0, 0.2, 0]],
    ["Head", 5, [0, 0.4, 0]],
    ["Same", 6, [0, 0, 0]],
  ],
  [6, [0, 0.18, 0]],
);

describe("the shape of a figure", () => {
  const { capsules, balls } = shapeOf(person.figure, person.joints, person.pose);

  it("has bones of the trunk that continue each other without an edge", () => {
    const [hips, spine] = [5, 6].map((node) => capsules.find(({ to }) => to === node)!);
    expect(hips!.r1).toBe(spine!.r0);
  });

  it("gives a bone to the joint that turns it, and none to nodes in one place", () => {
    const shin = capsules.find(({ to }) => to === 2)!;
    expect([shin.from, shin.joint]).toEqual([1, 1]);
    expect(shin.length).toBeCloseTo(0.4, 5);
    expect(capsules.some(({ to }) => to === 7)).toBe(false);
  });

  it("makes thighs thicker than nothing and trunks wide from left to right", () => {
    expect(capsules.find(({ to }) => to === 2)!.r0).toBeGreaterThan(0.05);
    expect(capsules.find(({ to }) => to === 5)!.across).toEqual([3, 1]);
    expect(capsules.find(({ to }) => to === 2)!.across).toBeNull();
  });

  it("puts a ball where the head is, in place of its last bone", () => {
    expect(balls).toHaveLength(1);
    expect(balls[0]!.node).toBe(6);
    expect(capsules.some(({ to }) => to === balls[0]!.towards)).toBe(false);
  });

  it("finds left and right under other naming conventions", () => {
    for (const [left, right] of [
      ["mixamorig:LeftUpLeg", "mixamorig:RightUpLeg"],
      ["LHipJoint", "RHipJoint"],
      ["l_thigh", "r_thigh"],
      ["thigh.L", "thigh.R"],
    ]) {
      const other = body([
        ["Hips", null, [0, 1, 0]],
        [left!, 0, [0.1, 0, 0]],
        [right!, 0, [-0.1, 0, 0]],
        ["Spine", 0, [0, 0.2, 0]],
      ]);
      const spine = shapeOf(other.figure, other.joints, other.pose).capsules.find(({ to }) => to === 3)!;
      expect(spine.across, left).toEqual([2, 1]);
    }
  });

  it("draws no bone between a root on the ground and the hips", () => {
    const grounded = body([
      ["Root", null, [0, 0, 0]],
      ["Hips", 0, [0, 1, 0]],
      ["LeftFoot", 1, [0.1, -0.98, 0]],
      ["Spine", 1, [0, 0.2, 0]],
    ]);
    const { capsules } = shapeOf(grounded.figure, grounded.joints, grounded.pose);
    expect(capsules.map(({ from, to }) => [from, to])).toEqual([
      [1, 2],
      [1, 3],
    ]);
    const seated = body([
      ["Hips", null, [0, 0.1, 0]],
      ["Spine", 0, [0, 0.2, 0]],
    ]);
    expect(shapeOf(seated.figure, seated.joints, seated.pose).capsules).toHaveLength(1);
  });

  it("accepts names without a meaning", () => {
    const plain = body([
      ["a", null, [0, 1, 0]],
      ["b", 0, [0, 0.3, 0]],
    ]);
    const shape = shapeOf(plain.figure, plain.joints, plain.pose);
    expect(shape.capsules[0]!.r0).toBeGreaterThan(0.01);
    expect(shape.balls).toEqual([]);
  });
});
