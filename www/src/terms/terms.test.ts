import { expect, it } from "vitest";
import glossary from "../../../docs/glossary.md?raw";
import { termWords } from "./card";
import { TERMS } from "./terms";

/**
 * The names that the glossary explains: in bold at the start of a line, or a symbol in the first column of a
 * table.
 */
const explained = glossary.split("\n").flatMap((line) => {
  const name = /^- \*\*(.+?)\*\*:/.exec(line)?.[1];
  if (name) return [name, ...name.split(", ")];
  const symbol = /^\| ([^|]+) \|/.exec(line)?.[1];
  return symbol ? [symbol, ...symbol.split(", ")] : [];
});

it("all terms are in the glossary", () => {
  expect(explained.length).toBeGreaterThan(50);
  const unknown = Object.entries(TERMS).filter(([, { glossary }]) => !explained.includes(glossary));
  expect(unknown.map(([name]) => name)).toEqual([]);
});

for (const language of ["en", "de"])
  it(`each term has a title and an explanation of two sentences: ${language}`, async () => {
    const { texts } = await termWords(language);
    expect(Object.keys(texts).sort()).toEqual(Object.keys(TERMS).sort());
    const sentences = (words: string) =>
      words.split(/[.!?](?=\s[A-ZÄÖÜ]|$)/).filter((part) => part.trim()).length;
    const others = Object.values(texts).filter(({ words }) => sentences(words) !== 2);
    expect(others.map(({ title }) => title)).toEqual([]);
  });

it("the page uses every term", () => {
  const sources: Record<string, string> = import.meta.glob("../**/*.ts", {
    query: "?raw",
    import: "default",
    eager: true,
  });
  const views = Object.entries(sources).filter(([file]) => !/\/terms\.ts$|\.test\.ts$/.test(file));
  expect(views.length).toBeGreaterThan(50);
  const isAsked = (name: string) =>
    views.some(
      ([, text]) =>
        text.includes(`of="${name}"`) ||
        // In a sentence of the words.
        text.includes(`|${name}]`) ||
        (/<pg-term of=\$\{term\}/.test(text) && text.includes(`"${name}"`)),
    );
  expect(Object.keys(TERMS).filter((name) => !isAsked(name))).toEqual([]);
});
