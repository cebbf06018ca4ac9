import { expect, it, vi } from "vitest";
import { words as german } from "./de/lab";
import { shownPart, shownSplit } from "./lab";
import { SectionWords } from "./section";

it("calls the library's own parts and splits as the story does, in each language, and no others", () => {
  expect(["lower", "upper", "trunk"].map(shownPart)).toEqual(["legs", "arms", "trunk"]);
  expect(shownSplit({ id: "whole", title: "Whole body" })).toBe("Whole body");
  vi.spyOn(SectionWords.prototype, "now", "get").mockReturnValue(german);
  const found = ["lower", "left arm", "my arm", "constructor"].map(shownPart);
  expect(found).toEqual(["Beine", "linker Arm", "my arm", "constructor"]);
  expect(shownSplit({ id: "whole", title: "Whole body" })).toBe("Ganzer Körper");
  expect(shownSplit({ id: "mine", title: "Mine" })).toBe("Mine");
});
