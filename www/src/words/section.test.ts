import { expect, it } from "vitest";
import { SectionWords } from "./section";
import { WordsStore } from "./words";

it("loads the words at the first use, and again in another language", async () => {
  Object.assign(globalThis, { document: { documentElement: { lang: "" } } });
  const words = new WordsStore();
  await words.load("en");
  const section = new SectionWords(words, { en: async () => "yes", de: async () => "ja" });
  expect(() => section.now).toThrow("not loaded");
  await section.load();
  expect(section.now).toBe("yes");
  const changed = new Promise<void>((resolve) => section.on(resolve));
  await words.load("de");
  await changed;
  expect(section.now).toBe("ja");
});
