import { expect, it } from "vitest";
import citation from "../../../CITATION.cff?raw";
import { bibtex, FURTHER_WORKS, inWords, MODEL_PAPERS, type Work } from "./references";

/** The references of CITATION.cff, as far as the file uses YAML. */
function cited(): Record<string, string>[] {
  const [, list = ""] = citation.split("\nreferences:\n");
  return list
    .split(/^ {2}- /m)
    .slice(1)
    .map((item) => {
      const fields: Record<string, string> = {};
      const authors: string[] = [];
      for (const line of item.split("\n")) {
        const [, family, given] = /- \{ family-names: ([^,]+), given-names: (.+) \}/.exec(line) ?? [];
        if (family) authors.push(`${family}, ${given}`);
        const [, name, value] = /^ *([a-z-]+): (.+)$/.exec(line) ?? [];
        if (name && value && !family) fields[name] = value;
      }
      const institution = /institution: \{ name: (.+) \}/.exec(item)?.[1];
      return { ...fields, ...(institution && { institution }), authors: authors.join(" and ") };
    });
}

const asCited = (work: Work): Record<string, string> => {
  const { type, authors, title, year, where, volume, issue, start, end, doi, isbn } = work;
  const place = { article: "journal", "conference-paper": "collection-title", thesis: "institution" }[type];
  const fields = { type, title, year: String(year), [place]: where, volume, issue, start, end, doi, isbn };
  const known = Object.entries(fields).filter((field): field is [string, string] => field[1] !== undefined);
  return {
    ...Object.fromEntries(known),
    authors: authors.map(({ family, given }) => `${family}, ${given}`).join(" and "),
  };
};

it("the references equal those of CITATION.cff", () => {
  expect(cited()).toEqual([...MODEL_PAPERS, ...FURTHER_WORKS].map(asCited));
});

it("a reference is written as BibTeX and as a line of a list", () => {
  const [entropy] = MODEL_PAPERS;
  const text = bibtex(entropy!);
  expect(text).toMatch(
    /^@article\{velychko2018,\n {2}author = \{Velychko, Dmytro and Knopp, Benjamin and Endres, Dominik\},/,
  );
  expect(text).toMatch(
    /number = \{10\},\n {2}pages = \{724\},\n {2}year = \{2018\},\n {2}doi = \{10\.3390\/e20100724\},\n\}$/,
  );
  const [, wang] = FURTHER_WORKS;
  expect(inWords(wang!, "Doctoral thesis")).toBe(
    "Wang, J. M., Fleet, D. J., Hertzmann, A. (2008). Gaussian Process Dynamical Models for Human Motion. " +
      "IEEE Transactions on Pattern Analysis and Machine Intelligence 30(2), 283–298.",
  );
  const [thesis] = FURTHER_WORKS;
  expect(inWords(thesis!, "Dissertation")).toMatch(/Motor Production. Dissertation, Philipps University/);
});
