import { afterEach, expect, it } from "vitest";
import { duration, fixed, grouped, short, weight } from "./format";
import { languageChanges } from "./language";

it("writes numbers shortly", () => {
  const found = [0, 0.00012, 0.0123, 0.456, 4.56, 45.6, 456, 45678].map(short);
  expect(found).toEqual(["0", "1.2e-4", "0.012", "0.46", "4.6", "45.6", "456", "4.6e4"]);
  expect([0, 0.001, 0.5, 1].map(weight)).toEqual(["0.00", "<0.01", "0.50", "1.00"]);
  expect(grouped(-124275.4)).toBe("−124,275");
  expect([grouped(1234.567, 2), grouped(-0.001, 2)]).toEqual(["1,234.57", "0.00"]);
  expect([4.4, 80, 7510].map(duration)).toEqual(["4 s", "1 min 20 s", "2 h 5 min"]);
});

it("writes numbers as German does", () => {
  languageChanges.language = "de";
  expect([0.0123, 45.6, 45678].map(short)).toEqual(["0,012", "45,6", "4,6e4"]);
  expect([0.001, 0.5].map(weight)).toEqual(["<0,01", "0,50"]);
  expect([grouped(1234.567, 2), grouped(-124275.4), fixed(2.5, 1)]).toEqual(["1.234,57", "−124.275", "2,5"]);
});

afterEach(() => {
  languageChanges.language = "en";
});
