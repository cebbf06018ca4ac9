import { describe, expect, it } from "vitest";
import { decodeFirstMotion, encodeFirstMotion } from "./first-motion.js";

function walker() {
  const nodes = [
    { joint: 0, parent: null, endSite: false },
    { joint: 0, parent: 0, endSite: true },
  ];
  const frames = 5;
  const positions = Float32Array.from({ length: frames * 6 }, (_, i) => Math.sin(i) + i / 30);
  const parts = [{ name: "Körper", joints: [0] }];
  return { frames, frameTime: 1 / 30, figure: { nodes }, joints: ["Hüfte"], parts, positions };
}

describe("the first motion", () => {
  it("is decoded within half a millimetre, without drift", () => {
    const motion = walker();
    const back = decodeFirstMotion(encodeFirstMotion(motion).buffer as ArrayBuffer);
    expect({ ...back, positions: null }).toEqual({ ...motion, positions: null });
    for (const [i, value] of back.positions.entries())
      expect(Math.abs(value - motion.positions[i]!)).toBeLessThan(0.00051);
  });

  it("refuses truncated bytes", () => {
    const bytes = encodeFirstMotion(walker());
    expect(() => decodeFirstMotion(bytes.slice(0, -2).buffer as ArrayBuffer)).toThrow(/bytes of positions/);
    expect(() => decodeFirstMotion(new ArrayBuffer(2))).toThrow(/cut short/);
  });

  it("refuses NaN", () => {
    const motion = walker();
    motion.positions[7] = Number.NaN;
    expect(() => encodeFirstMotion(motion)).toThrow(/coordinate 7/);
  });
});
