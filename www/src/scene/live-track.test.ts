import { expect, it } from "vitest";
import type { Motion } from "../engine/protocol";
import { LiveTrack } from "./live-track";

/** Frames of one node that walks along z, a metre a frame. */
function walk(from: number, frames: number): Motion {
  const positions = Float32Array.from({ length: frames * 6 }, (_, i) =>
    i % 6 === 2 ? from + Math.floor(i / 6) : i % 6 === 5 ? from + Math.floor(i / 6) + 1 : 0,
  );
  return { positions, frames, nodes: 2, frameTime: 1 / 30 };
}

it("keeps the last frames, with unchanged numbers", () => {
  const track = new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 10);
  for (let frame = 0; frame < 50; frame += 5) track.append(walk(frame, 5));
  expect(track.last).toBe(49);
  expect(track.first).toBeGreaterThan(25);
  expect(track.at(45.5)[2]).toBeCloseTo(45.5);
  expect(track.at(track.first)[2]).toBeCloseTo(track.first);
});

it("replaces its newest frames", () => {
  const track = new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 10);
  for (let frame = 0; frame < 50; frame += 5) track.append(walk(frame, 5));
  track.cutAfter(46);
  expect([track.last, track.frame(46)?.[2], track.frame(46)?.length, track.frame(47)]).toEqual([
    46,
    46,
    6,
    null,
  ]);
  track.append(walk(80, 2));
  expect([track.last, track.frame(47)?.[2], track.frame(track.first - 1)]).toEqual([48, 80, null]);
  track.cutAfter(60);
  expect(track.last).toBe(48);
  track.cutAfter(0);
  expect([track.last, track.motion.frames]).toEqual([track.first - 1, 0]);
});

it("starts at the place and in the direction of the figure, and turns displacements back", () => {
  const track = new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 10);
  track.append(walk(0, 3));
  // Turned by 90 degrees to the left: along x.
  track.alignWith(Float32Array.from([5, 0, 7, 6, 0, 7]));
  expect([...track.at(2)].map((x) => Math.round(x))).toEqual([7, 0, 7, 8, 0, 7]);
  const [x, y, z] = track.turnedBack([1, 0.5, 0]);
  expect([x, y, z].map((value) => Math.round(value * 2) / 2)).toEqual([0, 0.5, 1]);
});

it("knows the frames of a recording that moves a part", () => {
  const track = new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 10);
  for (let frame = 0; frame < 30; frame += 5) track.append(walk(frame, 5));
  track.append(walk(30, 3), [], [null, 7, 8]);
  expect([29, 30, 31, 31.5, 32].map((frame) => track.recordedAt(frame))).toEqual([null, null, 7, 7.5, 8]);
  track.cutAfter(30);
  track.append(walk(31, 1), [], [4]);
  expect([track.recordedAt(30), track.recordedAt(31)]).toEqual([null, 4]);
});
