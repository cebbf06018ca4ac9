// The works behind the models. CITATION.cff has the same for programs; a test compares both.

export interface Work {
  /** The key of its BibTeX entry. */
  key: string;
  type: "article" | "conference-paper" | "thesis";
  authors: { family: string; given: string }[];
  title: string;
  year: number;
  /** The journal, the proceedings or the university. */
  where: string;
  volume?: string;
  issue?: string;
  /** The first and the last page, or the number of an article. */
  start?: string;
  end?: string;
  doi?: string;
  /** The title of the book that contains it. */
  isbn?: string;
}

const velychko = { family: "Velychko", given: "Dmytro" };
const knopp = { family: "Knopp", given: "Benjamin" };
const endres = { family: "Endres", given: "Dominik" };

/** The papers of the model. */
export const MODEL_PAPERS: Work[] = [
  {
    key: "velychko2018",
    type: "article",
    authors: [velychko, knopp, endres],
    title:
      "Making the Coupled Gaussian Process Dynamical Model Modular and Scalable with Variational Approximations",
    year: 2018,
    where: "Entropy",
    volume: "20",
    issue: "10",
    start: "724",
    doi: "10.3390/e20100724",
  },
  {
    key: "velychko2017",
    type: "conference-paper",
    authors: [velychko, knopp, endres],
    title: "The Variational Coupled Gaussian Process Dynamical Model",
    year: 2017,
    where:
      "Artificial Neural Networks and Machine Learning - ICANN 2017, Proceedings, Part I, Lecture Notes in Computer Science",
    volume: "10613",
    start: "291",
    end: "299",
    // The DOI of the volume, which the paper itself names.
    doi: "10.1007/978-3-319-68600-4",
    isbn: "978-3-319-68600-4",
  },
  {
    key: "knopp2019",
    type: "article",
    authors: [knopp, velychko, { family: "Dreibrodt", given: "Johannes" }, endres],
    title:
      "Predicting Perceived Naturalness of Human Animations Based on Generative Movement Primitive Models",
    year: 2019,
    where: "ACM Transactions on Applied Perception",
    volume: "16",
    issue: "3",
    start: "15",
    doi: "10.1145/3355401",
  },
];

/** The works that these papers build on. */
export const FURTHER_WORKS: Work[] = [
  {
    key: "velychko2020",
    type: "thesis",
    authors: [velychko],
    title: "Probabilistic Models of Motor Production",
    year: 2020,
    where: "Philipps University of Marburg",
  },
  {
    key: "wang2008",
    type: "article",
    authors: [
      { family: "Wang", given: "Jack M." },
      { family: "Fleet", given: "David J." },
      { family: "Hertzmann", given: "Aaron" },
    ],
    title: "Gaussian Process Dynamical Models for Human Motion",
    year: 2008,
    where: "IEEE Transactions on Pattern Analysis and Machine Intelligence",
    volume: "30",
    issue: "2",
    start: "283",
    end: "298",
    doi: "10.1109/TPAMI.2007.1167",
  },
  {
    key: "titsias2010",
    type: "conference-paper",
    authors: [
      { family: "Titsias", given: "Michalis K." },
      { family: "Lawrence", given: "Neil D." },
    ],
    title: "Bayesian Gaussian Process Latent Variable Model",
    year: 2010,
    where:
      "Proceedings of the Thirteenth International Conference on Artificial Intelligence and Statistics (AISTATS)",
    start: "844",
    end: "851",
  },
];

const ENTRIES: Record<Work["type"], { entry: string; where: string }> = {
  article: { entry: "article", where: "journal" },
  "conference-paper": { entry: "inproceedings", where: "booktitle" },
  thesis: { entry: "phdthesis", where: "school" },
};

/** A work as a BibTeX entry. */
export function bibtex(work: Work): string {
  const { key, type, authors, title, year, volume, issue, start, end, doi, isbn } = work;
  const { entry, where } = ENTRIES[type];
  const fields: [string, string | undefined][] = [
    ["author", authors.map(({ family, given }) => `${family}, ${given}`).join(" and ")],
    // Braces keep the capitals of names such as Gaussian.
    ["title", `{${title}}`],
    [where, work.where],
    ["volume", volume],
    ["number", issue],
    ["pages", end ? `${start}--${end}` : start],
    ["year", String(year)],
    ["doi", doi],
    ["isbn", isbn],
  ];
  const lines = fields.flatMap(([name, value]) => (value === undefined ? [] : [`  ${name} = {${value}},`]));
  return [`@${entry}{${key},`, ...lines, "}"].join("\n");
}

/** A work in a line, for a list of references. `thesis`: what a thesis is called. */
export function inWords(work: Work, thesis: string): string {
  const { authors, year, title, where, volume, issue, start, end, type } = work;
  const names = authors.map(({ family, given }) =>
    `${family}, ${given.replace(/(\p{L})[\p{L}]+/gu, "$1.")}`.replace("..", "."),
  );
  const number = volume ? ` ${volume}${issue ? `(${issue})` : ""}` : "";
  const pages = start ? `, ${start}${end ? `–${end}` : ""}` : "";
  return `${names.join(", ")} (${year}). ${title}. ${type === "thesis" ? `${thesis}, ` : ""}${where}${number}${pages}.`;
}
