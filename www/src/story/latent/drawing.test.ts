import { expect, it } from "vitest";
import { principalAxes, project } from "../../latents/projection";
import { Plane } from "../../latents/plane";
import { axesAt, lift, nearestRow, pixelsAt, projectPath, lapOf } from "./drawing";

/** A tilted ellipse in three dimensions. */
const path = Float64Array.from({ length: 3 * 60 }, (_, i) => {
  const angle = (2 * Math.PI * Math.floor(i / 3)) / 60;
  return [3 * Math.cos(angle), Math.sin(angle), 0.4 * Math.cos(angle) + 2][i % 3]!;
});
const projection = principalAxes(path, 3);
const seen = projectPath(projection, path);

it("lifts a place on the path to the path", () => {
  for (const row of [0, 17, 44]) {
    const [right, up] = [seen[3 * row]!, seen[3 * row + 1]!];
    expect(nearestRow(seen, right, up)).toBe(row);
    const lifted = lift(projection, seen, right, up);
    lifted.forEach((value, a) => expect(value).toBeCloseTo(path[3 * row + a]!, 1));
  }
});

it("lifts a place off the path to a point that the plot shows there", () => {
  const at = project(projection, lift(projection, seen, 5, -2), 0, new Float64Array(3));
  expect(at[0]).toBeCloseTo(5, 9);
  expect(at[1]).toBeCloseTo(-2, 9);
});

it("finds the place at pixels, and the pixels of a place", () => {
  const plane = new Plane({ width: 100, height: 200, projection, turn: { about: 0, tilt: 0 } });
  const [x, y] = pixelsAt(plane, projection, [1.5, -0.4]);
  expect(axesAt(plane, projection, x, y)).toEqual([1.5, -0.4].map((number) => expect.closeTo(number, 9)));
  expect([x > 50, y > 100]).toEqual([true, true]);
});

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
