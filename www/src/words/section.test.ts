import { expect, it } from "vitest";
import { SectionWords, viewWords } from "./section";
import { WordsStore } from "./words";

it("loads the words at the first use, and again in another language", async () => {
  Object.assign(globalThis, { document: { documentElement: { lang: "" } } });
  const words = new WordsStore();
  await words.load("en");
  const section = new SectionWords(words, {
    en: async () => ({ words: "yes" }),
    de: async () => ({ words: "ja" }),
  });
  expect(() => section.now).toThrow("not loaded");
  await section.load();
  expect(section.now).toBe("yes");
  const changed = new Promise<void>((resolve) => section.on(resolve));
  await words.load("de");
  await changed;
  expect(section.now).toBe("ja");
});

it("gives the words of a view to a notice before they have loaded, in the language of the document", async () => {
  Object.assign(globalThis, { document: { documentElement: { lang: "de" } } });
  const view = viewWords({ en: async () => ({ words: "yes" }), de: async () => ({ words: "ja" }) });
  expect(() => view.now()).toThrow("not loaded");
  expect(await new Promise((resolve) => view.soon(resolve))).toBe("ja");
  const words = new WordsStore();
  await words.load("en");
  await view.load(words);
  let given = "";
  view.soon((now) => {
    given = now;
  });
  expect(given).toBe("yes");
});
