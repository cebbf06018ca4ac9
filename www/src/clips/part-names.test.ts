import { expect, it } from "vitest";
import { partColour } from "../ui/palette";
import { freeName, partColours, renamed, nameProblem } from "./part-names";

const PARTS = [{ name: "legs" }, { name: "part 3" }];

it("each part has its own name, and a refused name has a reason", () => {
  expect(nameProblem(PARTS, 0, "hips")).toBe("");
  expect(renamed(PARTS, 0, "hips")).toEqual([{ name: "hips" }, { name: "part 3" }]);
  expect(nameProblem(PARTS, 1, "legs")).toBe("Another part is called “legs”.");
  expect(nameProblem(PARTS, 0, "")).toBe("A part needs a name.");
  // A part may keep its name.
  expect(nameProblem(PARTS, 0, "legs")).toBe("");
  expect(freeName(PARTS)).toBe("part 4");
});

it("parts have the colours of the trained model, and empty parts have none", () => {
  const [none, ...colours] = partColours([0, 5, 0, 2]);
  expect(colours).toEqual([partColour(0), none, partColour(1)]);
});
