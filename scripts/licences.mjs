// The licences of the software of others in the site and in the npm package: crates in the wasm and npm
// packages in the page. Each text appears once.
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { at, Failure, output } from "./run.mjs";

/** @typedef {{ name: string, version: string, licence: string, folder: string }} Part */

const IS_LICENCE = /^(licen[cs]e|copying|notice|unlicense)([-._].*)?$/i;
/** The licence of a part that leaves the choice, and where its text is. */
const MAY_BE_MIT = /^[^()]*\bMIT\b( OR |\/)|( OR |\/)MIT\b[^()]*$/;
const IS_MIT_OR_NOTICE = /mit|notice/i;

/** The crates in the wasm, without our own. */
const wasmCrates = () => crates("vcgpdm-wasm", "--filter-platform", "wasm32-unknown-unknown");

/**
 * The crates in what a crate of ours compiles to, without our own.
 * @param {string} crate
 * @param {string[]} options further options of cargo metadata
 * @returns {Part[]}
 */
function crates(crate, ...options) {
  const text = output("cargo", "metadata", "--locked", "--format-version", "1", ...options);
  const { packages, resolve } = JSON.parse(text ?? "null") ?? {};
  if (!packages) throw new Failure("cargo metadata failed");
  /** Macros write source code; nothing of them is in the result. */
  const macros = new Set(
    packages
      .filter((/** @type {any} */ { targets }) =>
        targets.some((/** @type {any} */ { kind }) => kind.includes("proc-macro")),
      )
      .map((/** @type {{ id: string }} */ { id }) => id),
  );
  const nodes = new Map(resolve.nodes.map((/** @type {{ id: string }} */ node) => [node.id, node]));
  const inside = new Set();
  const visit = (/** @type {string} */ id) => {
    if (inside.has(id) || macros.has(id)) return;
    inside.add(id);
    // Build scripts and tests are not in the result.
    for (const { pkg, dep_kinds } of nodes.get(id).deps)
      if (dep_kinds.some((/** @type {{ kind: string | null }} */ { kind }) => kind === null)) visit(pkg);
  };
  visit(packages.find((/** @type {{ name: string }} */ { name }) => name === crate).id);
  return packages
    .filter(
      (/** @type {{ id: string, source: string | null }} */ { id, source }) =>
        inside.has(id) && source !== null,
    )
    .map((/** @type {any} */ { name, version, license, manifest_path }) => ({
      ...{ name, version, licence: license ?? "see below", folder: dirname(manifest_path) },
    }));
}

/** The npm packages that the page imports, with their dependencies. @returns {Part[]} */
function npmPackages() {
  /** @type {Map<string, Part>} */
  const found = new Map();
  const visit = (/** @type {string} */ manifest) => {
    const { dependencies = {} } = JSON.parse(readFileSync(manifest, "utf8"));
    const require = createRequire(manifest);
    for (const name of Object.keys(dependencies)) {
      const folder = require.resolve
        .paths(name)
        ?.map((place) => join(place, name))
        .find((place) => existsSync(join(place, "package.json")));
      if (!folder) throw new Failure(`${name} is not installed`);
      const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
      // The page contains no types.
      if (found.has(name) || name.startsWith("@types/")) continue;
      found.set(name, { name, version, licence: license ?? "see below", folder });
      visit(join(folder, "package.json"));
    }
  };
  visit(at("www/package.json"));
  return [...found.values()];
}

/** The notice for these parts. */
function notice(/** @type {Part[]} */ parts) {
  /** @type {Map<string, string[]>} */
  const texts = new Map();
  const lines = parts.map((part) => {
    const { name, version, licence, folder } = part;
    const all = readdirSync(folder).filter((file) => IS_LICENCE.test(file));
    const mit = MAY_BE_MIT.test(licence) && all.some((file) => /mit/i.test(file));
    const files = mit ? all.filter((file) => IS_MIT_OR_NOTICE.test(file)) : all;
    for (const file of files) {
      const text = readFileSync(join(folder, file), "utf8").replaceAll("\r\n", "\n").trim();
      texts.set(text, [...(texts.get(text) ?? []), `${name} ${version}`]);
    }
    return `${name} ${version}: ${licence}${files.length === 0 ? " (without a licence text)" : ""}`;
  });
  const quoted = [...texts].map(([text, users]) => `${"-".repeat(72)}\n${users.join(", ")}\n\n${text}`);
  const choice = "Parts that may be used under MIT or another licence are used under MIT.";
  return `This contains software of others. ${choice}\n\n${lines.join("\n")}\n\n${quoted.join("\n\n")}\n`;
}

/** The npm packages in `vcgpdm/figure`. */
const figurePackages = () => npmPackages().filter(({ name }) => name === "three");

const sorted = (/** @type {Part[]} */ parts) => parts.sort((a, b) => a.name.localeCompare(b.name, "en"));

/** For the npm package, which holds the wasm and, in its figure, three.js. */
export const packageNotice = () => notice(sorted([...wasmCrates(), ...figurePackages()]));

/** For the wheels of the Python package, which hold the module, and the same figure and wasm as its widget. */
export function wheelNotice() {
  const module = crates("vcgpdm-python", "--manifest-path", at("crate/python/Cargo.toml"));
  const parts = [...module, ...wasmCrates(), ...figurePackages()];
  return notice(sorted([...new Map(parts.map((part) => [`${part.name} ${part.version}`, part])).values()]));
}

/** Writes `licences.txt` next to the page. */
export function writeLicences() {
  mkdirSync(at("www/public"), { recursive: true });
  writeFileSync(at("www/public/licences.txt"), notice(sorted([...wasmCrates(), ...npmPackages()])));
}
