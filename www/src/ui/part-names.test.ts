import { expect, it } from "vitest";
import { partColour } from "./palette";
import { freeName, partColours, renamed, nameProblem } from "./part-names";

const PARTS = [{ name: "legs" }, { name: "part 3" }];

it("gives a part a name of its own, and says why another is refused", () => {
  expect(nameProblem(PARTS, 0, "hips")).toBe("");
  expect(renamed(PARTS, 0, "hips")).toEqual([{ name: "hips" }, { name: "part 3" }]);
  expect(nameProblem(PARTS, 1, "legs")).toBe("Another part is called “legs”.");
  expect(nameProblem(PARTS, 0, "")).toBe("A part needs a name.");
  // It may keep its own.
  expect(nameProblem(PARTS, 0, "legs")).toBe("");
  expect(freeName(PARTS)).toBe("part 4");
});

it("colours parts as the trained model will, and an empty one not at all", () => {
  const [none, ...colours] = partColours([0, 5, 0, 2]);
  expect(colours).toEqual([partColour(0), none, partColour(1)]);
});
