import { describe, expect, it } from "vitest";
import { partOfJoints } from "../scene/joints";
import { completeSplit, filledSplit, moveBranch, partsFor } from "./parts";

//   0 - 1 - 2
//     \ 3 - 4
const joints = [null, 0, 1, 0, 3].map((parent) => ({ name: "", parent, channels: [] }));
const presets = [
  { id: "whole", title: "Whole body", parts: [{ name: "body", joints: [0, 1, 2, 3, 4] }] },
  {
    id: "lower-upper",
    title: "",
    parts: [
      { name: "lower", joints: [0, 1, 2] },
      { name: "upper", joints: [3, 4] },
    ],
  },
];

describe("parts", () => {
  it("come from the chosen preset, or the first", () => {
    expect(partsFor({ joints, presets }, "lower-upper", [])).toHaveLength(2);
    expect(partsFor({ joints, presets }, "no-such", [])[0]!.name).toBe("body");
    expect(partsFor({ joints, presets }, "hand", [])[0]!.name).toBe("body");
  });

  it("by hand have every joint once", () => {
    const split = [
      { name: "a", joints: [1, 900] },
      { name: "none", joints: [] },
      { name: "b", joints: [3] },
    ];
    const [a, b] = [
      { name: "a", joints: [0, 1, 2] },
      { name: "b", joints: [3, 4] },
    ];
    expect(completeSplit(joints, split)).toEqual([a, b]);
    expect(filledSplit(joints, split)).toEqual([a, { name: "none", joints: [] }, b]);
  });

  it("move a whole branch", () => {
    const parts = moveBranch(joints, presets[1]!.parts, 1, 1);
    expect(parts).toEqual([
      { name: "lower", joints: [0] },
      { name: "upper", joints: [1, 2, 3, 4] },
    ]);
    expect([...partOfJoints(5, parts)]).toEqual([0, 1, 1, 1, 1]);
  });
});
