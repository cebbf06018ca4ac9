import { expect, it } from "vitest";
import citation from "../../../CITATION.cff?raw";
import citing from "../../../docs/citing.md?raw";
import papers from "./papers.bib?raw";
import { WORKS } from "./references";

const field = (item: string, name: string) => new RegExp(`^ *${name}: (.+)$`, "m").exec(item)?.[1];

it("has the works of CITATION.cff, and the entries of the papers", () => {
  const [, list = ""] = citation.split("\nreferences:\n");
  const cited = list.split(/^ {2}- /m).slice(1);
  expect(cited.length).toBeGreaterThan(5);
  for (const item of cited) {
    const [title, year, doi] = ["title", "year", "doi"].map((name) => field(item, name));
    const families = [...item.matchAll(/family-names: ([^,]+)/g)].map(([, family]) => family);
    const work = WORKS.find(({ words }) => words.includes(`(${year}). ${title}.`));
    expect(work?.words.match(/\p{L}+(?=, \p{Lu}\.)/gu)).toEqual(families);
    expect(work?.doi).toBe(doi);
  }
  expect(citing).toContain(papers);
  for (const [, doi] of papers.matchAll(/doi = \{(.+)\}/g))
    expect(WORKS.slice(0, 3).map((work) => work.doi)).toContain(doi);
});
