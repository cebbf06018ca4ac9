import { expect, it } from "vitest";

const SOURCES = import.meta.glob<string>(
  ["../**/*.ts", "!../words/**", "!../**/{en,de,entry}.ts", "!../**/*.test.ts"],
  { query: "?raw", import: "default", eager: true },
);

/** The end of a template or of an expression in it that begins at `start`, and the template's own text. */
function template(source: string, start: number): { end: number; text: string } {
  let text = "";
  let i = start;
  while (i < source.length && source[i] !== "`") {
    if (source.startsWith("${", i)) {
      i = expressionEnd(source, i + 2);
      text += "#";
    } else {
      text += source[i];
      i += 1;
    }
  }
  return { end: i + 1, text };
}

function expressionEnd(source: string, start: number): number {
  let [i, depth] = [start, 1];
  while (i < source.length && depth > 0) {
    if (source[i] === "`") i = template(source, i + 1).end;
    else {
      if (source[i] === "{") depth += 1;
      if (source[i] === "}") depth -= 1;
      i += 1;
    }
  }
  return i;
}

/** Words for a reader in the templates of a source: between tags, and in attributes that are read out. */
function wordsInTemplates(source: string): string[] {
  return [...source.matchAll(/\b(?:html|svg)`/g)].flatMap(({ index, 0: begin }) => {
    const { text } = template(source, index + begin.length);
    const attributes = [
      ...text.matchAll(/\b(?:aria-label|aria-description|title|alt|placeholder)="([^"]*)"/g),
    ];
    const between = text.replace(/<!--.*?-->/gs, " ").replace(/<[^>]*>/gs, " ");
    return [between, ...attributes.map(([, value = ""]) => value)].flatMap(
      // Not the names of formats and measures, such as CSV.
      (words) => (words.match(/\p{L}[\p{L}’' ]*\p{L}/gu) ?? []).filter((found) => /\p{Ll}/u.test(found)),
    );
  });
}

it("finds a sentence in a template, also in one within another, and in a label", () => {
  const inner = "html`<b>Hello</b>`";
  const source = `html\`<p>\${a ? ${inner} : b}</p><i aria-label="Close it" class="x y"></i>\``;
  expect(wordsInTemplates(source)).toEqual(["Close it", "Hello"]);
});

it("keeps the sentences of the story, for teachers, and of the Lab in the folder of words", () => {
  expect(Object.keys(SOURCES).length).toBeGreaterThan(10);
  const found = Object.entries(SOURCES).flatMap(([file, source]) =>
    wordsInTemplates(source).map((words) => `${file}: ${words}`),
  );
  expect(found).toEqual([]);
});
