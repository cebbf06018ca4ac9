import { expect, it, vi } from "vitest";
import { lab as german } from "./de/lab";
import { shownPart, shownSplit } from "./lab";
import { SectionWords } from "./section";

it("translates the names of the library's own parts and splits, and no others", () => {
  expect(shownPart("lower")).toBe("lower");
  expect(shownSplit({ id: "whole", title: "Whole body" })).toBe("Whole body");
  vi.spyOn(SectionWords.prototype, "now", "get").mockReturnValue(german);
  expect(["lower", "left arm", "my arm", "constructor"].map(shownPart)).toEqual([
    "Unterkörper",
    "linker Arm",
    "my arm",
    "constructor",
  ]);
  expect(shownSplit({ id: "whole", title: "Whole body" })).toBe("Ganzer Körper");
  expect(shownSplit({ id: "mine", title: "Mine" })).toBe("Mine");
});
