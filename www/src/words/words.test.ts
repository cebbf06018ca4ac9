import { expect, it } from "vitest";
import { words as de } from "./de";
import { words as en } from "./en";
import { preferredLanguage } from "./words";

it("prefers the visitor's choice, then the first language of the browser that the page has, then English", () => {
  expect(preferredLanguage("de", ["en-GB"])).toBe("de");
  expect(preferredLanguage(null, ["fr", "de-AT", "en"])).toBe("de");
  expect(preferredLanguage("xx", ["fr"])).toBe("en");
});

const count = (text: string) => text.split(/\s+/).filter(Boolean).length;

for (const [language, words] of Object.entries({ en, de }))
  it(`has a title and a text of 30 to 90 words for each chapter: ${language}`, () => {
    for (const [name, { title, text }] of Object.entries(words.chapters)) {
      expect(count(title), name).toBeLessThan(10);
      expect(count(text), name).toBeGreaterThanOrEqual(30);
      expect(count(text), name).toBeLessThanOrEqual(90);
    }
  });
