import { expect, it } from "vitest";
import type { LibraryInfo } from "../../engine/library-protocol";
import { measureHandsAndFeet } from "./borrow-chapter";

const names = ["Hips", "LeftHand", "RightHand", "LeftFoot", "RightFoot"];
const info = {
  joints: names.map((name) => ({ name, parent: null, channels: [] })),
  figure: { nodes: names.map((_, joint) => ({ joint, parent: null, endSite: false })) },
} as unknown as Pick<LibraryInfo, "joints" | "figure">;

it("measures hands that rise and swing, and feet that step twice a second, while the body moves on", () => {
  const [frames, rate] = [301, 100];
  const positions = new Float32Array(frames * 15);
  for (let frame = 0; frame < frames; frame++) {
    const t = frame / rate;
    const x = 1.2 * t;
    const stride = 0.3 * Math.cos(2 * Math.PI * t);
    const places = [
      [x, 1, 0],
      [x, 1.5, 0.5 * t],
      [x, 1.3, 0.5 * t],
      [x + stride, 0, 0],
      [x - stride, 0, 0],
    ];
    positions.set(places.flat(), 15 * frame);
  }
  const measured = measureHandsAndFeet(info, { positions, frames, nodes: 5, frameTime: 1 / rate });
  expect(measured?.height).toBeCloseTo(0.4, 5);
  expect(measured?.speed).toBeCloseTo(0.5, 4);
  expect(measured?.steps).toBeCloseTo(2, 5);
});

it("counts no steps of feet that spread and close in one place", () => {
  const [frames, rate] = [201, 100];
  const positions = new Float32Array(frames * 15);
  for (let frame = 0; frame < frames; frame++) {
    const t = frame / rate;
    const sway = 0.01 * Math.cos(2 * Math.PI * t);
    const spread = 0.3 * Math.sin(2 * Math.PI * t);
    positions.set([sway, 1, 0, 0, 1.5, 0, 0, 1.5, 0, spread, 0, 0, -spread, 0, 0], 15 * frame);
  }
  expect(measureHandsAndFeet(info, { positions, frames, nodes: 5, frameTime: 1 / rate })?.steps).toBe(0);
});

it("measures nothing on a body without hands", () => {
  const motion = { positions: new Float32Array(30), frames: 2, nodes: 5, frameTime: 0.1 };
  expect(measureHandsAndFeet({ ...info, joints: info.joints.slice(0, 1) }, motion)).toBeNull();
});
