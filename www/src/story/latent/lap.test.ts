import { expect, it } from "vitest";
import { lapOf } from "./drawing";

const circle = (frames: number, period: number) =>
  Float64Array.from({ length: 2 * frames }, (_, i) => {
    const angle = (2 * Math.PI * Math.floor(i / 2)) / period;
    return i % 2 === 0 ? Math.cos(angle) : Math.sin(angle);
  });

it("finds the shortest time after which a path repeats itself", () => {
  const { first, frames, path } = lapOf(circle(300, 34), 2);
  expect([first, frames, path.length]).toEqual([150, 34, 68]);
});

it("forgets the start of the path", () => {
  const path = circle(300, 41);
  path.fill(7, 0, 200);
  expect(lapOf(path, 2).frames).toBe(41);
});
