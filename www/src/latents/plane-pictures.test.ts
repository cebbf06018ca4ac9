import { expect, it, vi } from "vitest";
import type { RolloutResult } from "../engine/protocol";
import { PlanePictures, type Wanted } from "./plane-pictures";

const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
const wanted = (coupling: number, width = 100, part = 0): Wanted => ({
  rollout: { revision: 1, request: { alpha: [[coupling]] } } as unknown as RolloutResult,
  part,
  picture: { width, height: 50, centre: [0], right: [1], down: [0], colour: [1, 2, 3] },
});

function scene() {
  const painted: { wanted: Wanted; close: ReturnType<typeof vi.fn> }[] = [];
  const paint = vi.fn(async (wanted: Wanted) => {
    const picture = { wanted, close: vi.fn() };
    painted.push(picture);
    return picture as unknown as ImageBitmap;
  });
  const [arrived, failed] = [vi.fn(), vi.fn()];
  return { painted, paint, arrived, failed, pictures: new PlanePictures(paint, arrived, failed) };
}

it("asks once for a picture, and tells when it has arrived", async () => {
  const { pictures, paint, arrived } = scene();
  expect(pictures.pictureOf(wanted(1))).toBeNull();
  expect(pictures.pictureOf(wanted(1))).toBeNull();
  await settled();
  expect(arrived).toHaveBeenCalledOnce();
  expect(pictures.pictureOf(wanted(1))).not.toBeNull();
  expect(paint).toHaveBeenCalledOnce();
});

it("keeps the picture of other couplings until the new one has arrived, but not that of another plot", async () => {
  const { pictures, painted } = scene();
  pictures.pictureOf(wanted(1));
  await settled();
  expect(pictures.pictureOf(wanted(2))).not.toBeNull();
  await settled();
  expect(painted[0]?.close).toHaveBeenCalledOnce();
  expect(pictures.pictureOf(wanted(2, 120))).toBeNull();
});

it("closes all pictures when nothing is shown any more, and asks again afterwards", async () => {
  const { pictures, painted, paint } = scene();
  pictures.pictureOf(wanted(1));
  pictures.pictureOf(wanted(1, 100, 1));
  await settled();
  pictures.clear();
  expect(painted.map(({ close }) => close.mock.calls.length)).toEqual([1, 1]);
  expect(pictures.pictureOf(wanted(1))).toBeNull();
  expect(paint).toHaveBeenCalledTimes(3);
});
