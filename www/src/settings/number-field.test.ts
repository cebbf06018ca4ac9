import { expect, it } from "vitest";
import { limitWords } from "./number-field";

it("says which limit a value met, and nothing of a value within them", () => {
  const limits = { min: 10, max: 5000, step: 10 };
  const found = [20000, 3, 10, 5000, Number.NaN].map((asked) => limitWords(asked, limits));
  expect(found).toEqual(["At most 5,000.", "At least 10.", "", "", ""]);
});
