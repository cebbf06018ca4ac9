import { expect, it } from "vitest";
import { added, moved, partsByName, placeOf, without } from "./parts-of-columns";

const TABLE = ["arm_x", "arm_y", "leg_x"];
const PARTS = [
  { name: "arm", columns: ["arm_x", "arm_y"] },
  { name: "leg", columns: ["leg_x"] },
];

it("guesses parts by the beginnings of names, and one part where these tell nothing", () => {
  expect(partsByName(TABLE)).toEqual(PARTS);
  expect(partsByName(["left.hip", "right.hip", "left.knee"])).toEqual([
    { name: "left", columns: ["left.hip", "left.knee"] },
    { name: "right", columns: ["right.hip"] },
  ]);
  const whole = (columns: string[]) => [{ name: "whole", columns }];
  // Without prefixes, with one common prefix, and with more prefixes than the maximum number of parts.
  for (const columns of [["x", "arm_y"], ["a_x", "a_y"], Array.from({ length: 9 }, (_, i) => `c${i}_x`)])
    expect(partsByName(columns)).toEqual(whole(columns));
});

it("moves a column, and keeps the order of the table", () => {
  const parts = moved(PARTS, TABLE, "arm_x", 1);
  expect(parts).toEqual([
    { name: "arm", columns: ["arm_y"] },
    { name: "leg", columns: ["arm_x", "leg_x"] },
  ]);
  expect([placeOf(parts, "arm_x"), placeOf(parts, "gone")]).toEqual([1, -1]);
});

it("adds and removes parts without losing a column", () => {
  const three = added(PARTS);
  expect(three.at(-1)).toEqual({ name: "part 3", columns: [] });
  expect(added(Array.from({ length: 8 }, (_, i) => ({ name: `${i}`, columns: [] })))).toHaveLength(8);
  expect(without(PARTS, TABLE, 0)).toEqual([{ name: "leg", columns: TABLE }]);
  expect(without(three, TABLE, 1)).toEqual([
    { name: "arm", columns: TABLE },
    { name: "part 3", columns: [] },
  ]);
  expect(without([{ name: "whole", columns: TABLE }], TABLE, 0)).toHaveLength(1);
});
