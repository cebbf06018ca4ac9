import { expect, it } from "vitest";
import { principalAxes, project } from "../../latents/projection";
import { lift, nearestRow, projectPath } from "./drawing";

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
