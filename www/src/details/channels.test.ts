import { expect, it } from "vitest";
import { channelsOf, courseOf, plottedCsv, readMotion, speedOf } from "./channels";

const joints = [
  { name: "hips", parent: null, channels: ["Xposition", "Zrotation"] },
  { name: "knee", parent: 0, channels: ["Xrotation"] },
];
const bvh =
  "HIERARCHY\nROOT hips\n{\n}\nMOTION\nFrames: 3\nFrame Time: 0.5\n1 170 10\n2 -175 20\n4 -160 40\n";

it("finds each channel's column and reads its numbers", () => {
  const channels = channelsOf(joints);
  expect(channels.map(({ joint, channel, isAngle }) => [joint, channel, isAngle])).toEqual([
    ["hips", "Xposition", false],
    ["hips", "Zrotation", true],
    ["knee", "Xrotation", true],
  ]);
  const motion = readMotion(bvh);
  expect(motion.frameTime).toBe(0.5);
  const courses = channels.map((channel) => courseOf(motion, channel));
  // The second angle passes 180 degrees.
  expect(courses).toEqual([
    [1, 2, 4],
    [170, 185, 200],
    [10, 20, 40],
  ]);
});

it("computes speeds in the middle and at both ends", () => {
  expect(speedOf([10, 20, 40], 0.5)).toEqual([20, 30, 40]);
  expect(speedOf([10], 0.5)).toEqual([0]);
});

it("writes motions of different lengths, with and without a horizontal quantity", () => {
  const titles = { x: "knee", y: "hips" };
  expect(plottedCsv(0.5, [{ name: "now", x: null, y: [1, 2] }], titles)).toBe(
    "frame,time (s),now: hips\r\n0,0,1\r\n1,0.5,2\r\n",
  );
  const both = [
    { name: "now", x: [3, 4], y: [1, 2] },
    { name: "learned", x: [5], y: [6] },
  ];
  expect(plottedCsv(0.5, both, titles)).toBe(
    "frame,time (s),now: knee,now: hips,learned: knee,learned: hips\r\n0,0,3,1,5,6\r\n1,0.5,4,2,,\r\n",
  );
});
