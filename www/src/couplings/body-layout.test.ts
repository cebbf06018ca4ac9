import { expect, it } from "vitest";
import { bowBetween, drawApart, HEIGHT, loopAt, WIDTH } from "./body-layout";

it("moves nodes away from each other, also from the same spot, and keeps them in the map", () => {
  for (const spots of [
    [
      { x: 85, y: 90 },
      { x: 85, y: 90 },
    ],
    [
      { x: 85, y: 150 },
      { x: 85, y: 60 },
      { x: 60, y: 90 },
      { x: 110, y: 90 },
    ],
    [
      { x: -40, y: 500 },
      { x: 85, y: 60 },
    ],
  ]) {
    const apart = drawApart(spots);
    apart.forEach((a, i) => {
      expect(a.x > 0 && a.x < WIDTH && a.y > 0 && a.y < HEIGHT).toBe(true);
      for (const b of apart.slice(i + 1)) expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeGreaterThan(40);
    });
  }
});

const UP = { x: 85, y: 40 };
const DOWN = { x: 85, y: 140 };

it("bends the arrows of both directions to different sides, with their middles apart", () => {
  const [there, back] = [bowBetween(UP, DOWN).middle, bowBetween(DOWN, UP).middle];
  expect(Math.sign(there.x - UP.x)).toBe(-Math.sign(back.x - UP.x));
  // A finger needs this much of a map that is drawn at twice its units.
  expect(Math.hypot(there.x - back.x, there.y - back.y)).toBeGreaterThan(24);
});

it("places the middle of a loop at its outermost point, and has no NaN for nodes on one spot", () => {
  const { middle, path } = loopAt(UP);
  expect(middle.y).toBeCloseTo(UP.y, 0);
  expect(middle.x - UP.x).toBeGreaterThan(24);
  expect(`${path} ${bowBetween(UP, UP).path}`).not.toContain("NaN");
});
