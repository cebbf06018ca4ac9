import { expect, it } from "vitest";
import { markPath } from "./marks";

it("draws a mark around its point", () => {
  expect(markPath("square", 10, 20, 5)).toBe("M5.70 15.70L14.30 15.70L14.30 24.30L5.70 24.30Z");
  expect(markPath("circle", 10, 20, 5)).toContain("A5 5");
});
