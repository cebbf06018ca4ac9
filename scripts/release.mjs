// `node scripts/release.mjs`: writes the addresses of Cargo.toml into CITATION.cff and .zenodo.json, and lists
// what the owner has to fill in before the first release. The exit status is 1 while something is missing.
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { at } from "./run.mjs";

/** The word in the place of the account that publishes. */
const OWNER = "OWNER";
/** The words in the places of names and ORCID iDs. */
const UNKNOWN = ["FAMILY NAME", "GIVEN NAMES", "0000-0000-0000-0000"];

/** The fields of package.json for a crate of Cargo's metadata; none until the owner is filled in. */
export function addresses(/** @type {{ repository: string | null, homepage: string | null }} */ crate) {
  const { repository, homepage } = crate;
  if (!repository || !homepage || repository.includes(OWNER) || homepage.includes(OWNER)) return {};
  return {
    repository: { type: "git", url: `git+${repository}.git` },
    homepage,
    bugs: { url: `${repository}/issues` },
  };
}

/** What is missing in these texts, in the order of the files. */
export function missing(/** @type {Record<string, string>} */ texts) {
  return Object.entries(texts).flatMap(([file, text]) =>
    [OWNER, ...UNKNOWN]
      .filter((word) => text.includes(word))
      .map((word) => `${file}: expected the real value, found ${word}`),
  );
}

/** CITATION.cff with the repository and the page of Cargo.toml. */
export function withAddresses(/** @type {string} */ citation, /** @type {string} */ cargo) {
  const field = (/** @type {string} */ name) =>
    cargo.match(new RegExp(`^${name} = "([^"]+)"$`, "m"))?.[1] ?? "";
  return citation
    .replace(/^repository-code: .*$/m, () => `repository-code: ${field("repository")}`)
    .replace(/^url: .*$/m, () => `url: ${field("homepage")}`);
}

/** .zenodo.json with the authors, version and licence of CITATION.cff. */
export function zenodo(/** @type {string} */ citation) {
  const [, authors = ""] = citation.match(/^authors:\n((?: .*\n)+)/m) ?? [];
  const value = (/** @type {string} */ text, /** @type {string} */ name) =>
    text.match(new RegExp(`(?:^|[{,] *|^ *)${name}: ([^,}\n]+?) *(?:[,}]|$)`, "m"))?.[1];
  const creators = [...authors.matchAll(/- \{(.*)\}/g)].map(([, author = ""]) => ({
    name: `${value(author, "family-names")}, ${value(author, "given-names")}`,
    orcid: value(author, "orcid")?.split("/").at(-1),
  }));
  const about = {
    title: value(citation, "title"),
    upload_type: "software",
    version: value(citation, "version"),
    license: "MIT",
    creators,
    keywords: ["Gaussian process", "motion capture", "movement primitives"],
    related_identifiers: [
      { identifier: "10.3390/e20100724", relation: "isSupplementTo", resource_type: "publication-article" },
    ],
  };
  return `${JSON.stringify(about, null, 2)}\n`;
}

function run() {
  const read = (/** @type {string} */ file) => readFileSync(at(file), "utf8");
  const cargo = read("Cargo.toml");
  const citation = withAddresses(read("CITATION.cff"), cargo);
  writeFileSync(at("CITATION.cff"), citation);
  writeFileSync(at(".zenodo.json"), zenodo(citation));
  // The comment in Cargo.toml explains the word.
  const code = cargo.replace(/^#.*$/gm, "");
  const open = missing({ "Cargo.toml": code, "CITATION.cff": citation });
  for (const line of open) console.error(line);
  process.exitCode = open.length > 0 ? 1 : 0;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) run();
