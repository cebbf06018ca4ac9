import { expect, it } from "vitest";
import { lightsOf } from "./point-lights";

/** A figure of these joints, each above the one before. */
function tower(names: string[]) {
  const nodes = names.map((_, joint) => ({ joint, parent: joint > 0 ? joint - 1 : null, endSite: false }));
  const pose = Float32Array.from(names.flatMap((_, i) => [0, 0.1 * i, 0]));
  return { figure: { nodes }, names, pose };
}
const lit = ({ figure, names, pose }: ReturnType<typeof tower>) =>
  lightsOf(figure, names, pose).map((node) => names[node]);

it("lights head, shoulders, elbows, wrists, hips, knees and ankles, and nothing else", () => {
  const sides = ["Left", "Right"].flatMap((side) =>
    ["Shoulder", "Arm", "ForeArm", "Hand", "HandThumb1", "UpLeg", "Leg", "Foot", "ToeBase"].map((name) => side + name),
  );
  const names = ["Hips", "Spine", "Neck", "Head", ...sides];
  expect(lit(tower(names))).toEqual([
    "Head",
    ...["Left", "Right"].flatMap((side) =>
      ["Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot"].map((name) => side + name),
    ),
  ]);
});

it("lights all joints of a body whose names say nothing, but those in one place once", () => {
  const body = tower(["a", "b", "c", "d"]);
  body.pose.set([0, 0.1, 0], 6);
  expect(lit(body)).toEqual(["a", "b", "d"]);
});

it("lights no ends of bones", () => {
  const body = tower(["a", "b"]);
  body.figure.nodes[1]!.endSite = true;
  expect(lit(body)).toEqual(["a"]);
});
