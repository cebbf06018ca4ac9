import { expect, it } from "vitest";
import type { LibraryInfo } from "../engine/library-protocol";
import { restingPartsText } from "./walk-couplings-view";

const info = {
  parts: [{ name: "lower" }, { name: "upper" }],
  primitives: [{ name: "walk" }, { name: "wave" }],
} as unknown as LibraryInfo;

it("names the part that rests, and the part that leads it", () => {
  const moves = (still: boolean, weight: number, met: boolean) => [
    { share: 1, still: false, leader: { part: 1, weight: 0.2, met } },
    { share: 0, still, leader: { part: 0, weight, met } },
  ];
  expect(restingPartsText(info, [0, 1], moves(false, 0.9, false))).toBe("");
  expect(restingPartsText(info, [0, 1], moves(true, 0.9, false))).toBe(
    "One pose: arms. 90 % of what comes next for arms is decided by legs, and legs: walk never learned to drive arms: wave.",
  );
  expect(restingPartsText(info, [0, 1], moves(true, 0.9, true))).toContain(
    "does not drive it under these couplings.",
  );
  expect(restingPartsText(info, [0, 1], moves(true, 0.1, true))).toContain(
    "its own predictions come to rest.",
  );
  expect(restingPartsText(info, [0], [{ share: 0, still: true, leader: null }])).toBe(
    "One pose: legs. Alone it comes to rest.",
  );
});
