import { describe, expect, it } from "vitest";
import { modelName, plain } from "../couplings/model-file";
import { motionName, type RolledOut } from "./saving";

const sequence = (name: string) => ({
  name,
  sha256: "",
  frames: 90,
  restsFrom: null,
  piece: null,
  bonesOf: null,
  whole: true,
});
const part = (name: string) => ({ name, joints: [], latent: 3, poseIps: 12 });
const asLearned: RolledOut = {
  info: {
    parts: [part("lower"), part("upper")],
    sequences: [sequence("35_01.bvh"), sequence("35_02.bvh")],
    frameTime: 1 / 30,
  },
  id: "1a2b3c4d",
  alpha: {},
  reading: "as-learned",
  sequence: 0,
  frames: 300,
};

describe("the name of a motion", () => {
  it("has the model, couplings, reading, start and length", () => {
    expect(modelName(asLearned)).toBe("35_01-2-parts-1a2b3c4d");
    expect(motionName(asLearned)).toBe("35_01-2-parts-1a2b3c4d-10s");
    const other = {
      ...asLearned,
      alpha: { "0.1": 5.00001 },
      reading: "re-inferred" as const,
      sequence: 1,
      frames: 75,
    };
    expect(motionName(other)).toBe("35_01-2-parts-1a2b3c4d-lower-upper-5-re-inferred-as-35_02-2.5s");
  });

  it("differs for different motions", () => {
    const many = { "0.0": 1, "0.1": 2, "1.0": 3, "1.1": 4 };
    const variants: RolledOut[] = [
      asLearned,
      { ...asLearned, id: "ffffffff" },
      { ...asLearned, alpha: { "0.1": 5 } },
      { ...asLearned, alpha: { "1.0": 5 } },
      { ...asLearned, alpha: { "0.1": 5 }, reading: "re-inferred" },
      { ...asLearned, alpha: many },
      { ...asLearned, alpha: { ...many, "1.1": 5 } },
      { ...asLearned, sequence: 1 },
      { ...asLearned, sequence: 1, frame: 9 },
      { ...asLearned, clip: "walk 5" },
      { ...asLearned, frames: 150 },
    ];
    expect(new Set(variants.map(motionName)).size).toBe(variants.length);
  });

  it("is valid on every file system", () => {
    expect(plain('../a: "b"/c?.')).toBe("a-b-c");
    const odd = {
      ...asLearned,
      info: { ...asLearned.info, sequences: [sequence("///")], parts: [part("Körper & Arm")] },
    };
    expect(motionName({ ...odd, alpha: { "0.0": 2 } })).toBe(
      "model-1-part-1a2b3c4d-Körper-Arm-Körper-Arm-2-10s",
    );
  });
});
