// What the files of a Rust package use of each other.
import { standsIn } from "./rooms.mjs";

/**
 * @typedef {object} Module what one file says
 * @property {string} file
 * @property {string[]} path `["gp", "psi"]` for gp/psi.rs and gp/psi/mod.rs, `[]` for the root
 * @property {string} code without comments, strings and tests
 * @property {string} tests the code of its tests
 * @property {Import[]} imports
 *
 * @typedef {{ name: string, path: string[], public: boolean }} Import `use` of one name; "*" for all
 */

const COMMENT_OR_TEXT =
  /\/\/[^\n]*|\/\*[\s\S]*?\*\/|(?<!\w)b?r(#*)"[\s\S]*?"\1|b?"(?:\\[\s\S]|[^"\\])*"|'(?:\\(?:x..|u\{[^}]*\}|.)|[^'\\\n])'/g;

/** The code without its comments, and without what stands in quotes where `texts` is false. */
export const bare = (/** @type {string} */ text, texts = false) =>
  text.replace(COMMENT_OR_TEXT, (found) => (found.startsWith("/") ? " " : texts ? found : '""'));

/** Where the block that opens at `open` closes. */
function closing(/** @type {string} */ code, /** @type {number} */ open) {
  let depth = 0;
  for (let i = open; i < code.length; i++) {
    if (code[i] === "{") depth += 1;
    if (code[i] === "}" && --depth === 0) return i + 1;
  }
  return code.length;
}

/** Divides code into what ships and what only tests see. */
function withoutTests(/** @type {string} */ code) {
  let tests = "";
  for (;;) {
    const found = code.match(/#\[cfg\(test\)\]\s*(?:#\[[^\]]*\]\s*)*(?:pub(?:\(\w+\))?\s+)?mod\s+\w+\s*\{/);
    if (found?.index === undefined) return { code, tests };
    const end = closing(code, found.index + found[0].length - 1);
    tests += code.slice(found.index + found[0].length, end - 1);
    code = code.slice(0, found.index) + code.slice(end);
  }
}

/** `a::{b, c::{self, d as e}}` as single paths. @returns {Omit<Import, "public">[]} */
function paths(/** @type {string} */ tree, /** @type {string[]} */ before = []) {
  const open = tree.indexOf("{");
  if (open < 0) {
    const [path = "", name] = tree.trim().split(/\s+as\s+/);
    const steps = [...before, ...path.split("::").map((step) => step.trim())].filter((step) => step !== "");
    if (steps.at(-1) === "self" && steps.length > 1) steps.pop();
    return steps.length > 0 ? [{ name: name ?? steps.at(-1) ?? "", path: steps }] : [];
  }
  const head = tree.slice(0, open).split("::");
  const inner = tree.slice(open + 1, tree.lastIndexOf("}"));
  const steps = [...before, ...head.map((step) => step.trim()).filter((step) => step !== "")];
  return branches(inner).flatMap((branch) => paths(branch, steps));
}

/** Divides at the commas that stand in no braces. */
function branches(/** @type {string} */ inner) {
  const found = [""];
  let depth = 0;
  for (const sign of inner) {
    if (sign === "{") depth += 1;
    if (sign === "}") depth -= 1;
    if (sign === "," && depth === 0) found.push("");
    else found.push(found.pop() + sign);
  }
  return found;
}

const USE = /(?<!\w)(pub(?:\([^)]*\))?\s+)?use\s+([^;]+);/g;

/**
 * @param {Map<string, string>} sources the text of each file, by its path below src/
 * @returns {Module[]}
 */
export function modulesOf(sources) {
  const modules = [...sources].map(([file, text]) => {
    const steps = file.replace(/\.rs$/, "").split("/");
    const last = steps.at(-1) ?? "";
    const path = ["lib", "main"].includes(file.replace(/\.rs$/, ""))
      ? []
      : last === "mod"
        ? steps.slice(0, -1)
        : steps;
    const { code, tests } = withoutTests(bare(text));
    return { file, path, code, tests, imports: importsOf(code, path) };
  });
  // Modules that only tests see: tests.rs, or whatever stands under #[cfg(test)].
  const onlyTests = modules.flatMap(({ path, code }) =>
    [...code.matchAll(/#\[cfg\(test\)\]\s*(?:pub(?:\(\w+\))?\s+)?mod\s+(\w+)\s*;/g)].map(([, name = ""]) =>
      [...path, name].join("::"),
    ),
  );
  return modules.map((module) => {
    const place = module.path.join("::");
    const forTests = onlyTests.some((path) => place === path || place.startsWith(`${path}::`));
    return forTests ? { ...module, code: "", tests: module.code + module.tests, imports: [] } : module;
  });
}

/** @returns {Import[]} */
function importsOf(/** @type {string} */ code, /** @type {string[]} */ path) {
  const children = childrenOf(code);
  return [...code.matchAll(USE)].flatMap(([, visible, tree = ""]) =>
    paths(tree).flatMap((found) => {
      const absolute = absolutePath(found.path, path, children);
      return absolute ? [{ name: found.name, path: absolute, public: visible !== undefined }] : [];
    }),
  );
}

const childrenOf = (/** @type {string} */ code) =>
  [...code.matchAll(/(?<!\w)mod\s+(\w+)\s*;/g)].map(([, name = ""]) => name);

/** From the root of the package; null where the path leads out of it. */
function absolutePath(
  /** @type {string[]} */ path,
  /** @type {string[]} */ place,
  /** @type {string[]} */ children,
) {
  const [first = "", ...rest] = path;
  if (first === "crate") return rest;
  if (first === "self") return [...place, ...rest];
  if (first === "super") {
    const up = path.findIndex((step) => step !== "super");
    const steps = up < 0 ? path.length : up;
    return [...place.slice(0, place.length - steps), ...path.slice(steps)];
  }
  return children.includes(first) ? [...place, ...path] : null;
}

/**
 * Which files use which. A use of a name that a mod.rs hands on counts as a use of the file that the name
 * stands in, and handing on is no use of its own.
 * @param {Module[]} modules
 * @param {{ tests: boolean }} options whether the uses of tests count too
 */
export function usesOf(modules, { tests }) {
  const byPath = new Map(modules.map((module) => [module.path.join("::"), module]));

  /** The file in which a path ends. @returns {Module | undefined} */
  const fileOf = (/** @type {string[]} */ path, depth = 0) => {
    for (let length = path.length; length >= 0; length--) {
      const module = byPath.get(path.slice(0, length).join("::"));
      if (!module) continue;
      const name = path[length];
      if (name === undefined || depth > 8) return module;
      const handed = module.imports.find((found) => found.name === name);
      if (handed) return fileOf([...handed.path, ...path.slice(length + 1)], depth + 1);
      return module;
    }
    return undefined;
  };

  /** @type {import("./rooms.mjs").Use[]} */
  const uses = [];
  for (const module of modules) {
    const add = (/** @type {string[]} */ path) => {
      const to = fileOf(path);
      if (to && to !== module) uses.push({ from: module.file, to: to.file });
    };
    const body = module.code.replace(USE, "");
    for (const { name, path, public: visible } of module.imports) {
      const handedOn = visible && module.path.every((step, i) => step === path[i]);
      if (!handedOn || new RegExp(`(?<!\\w)${name}(?!\\w)`).test(body))
        add(name === "*" ? path.slice(0, -1) : path);
    }
    for (const path of inlinePaths(body, module)) add(path);
    if (!tests) continue;
    // `super` in tests that stand in the file itself is the file; other names lead out of it as everywhere.
    const inTests = { ...module, path: module.code === "" ? module.path : [...module.path, "tests"] };
    for (const { path } of importsOf(module.tests, inTests.path))
      add(path.at(-1) === "*" ? path.slice(0, -1) : path);
    for (const path of inlinePaths(module.tests.replace(USE, ""), inTests)) add(path);
  }
  return uses;
}

/** Paths that stand in the code itself: `crate::gp::exp::exp(x)`. @returns {string[][]} */
function inlinePaths(/** @type {string} */ code, /** @type {{ path: string[] }} */ { path }) {
  const children = childrenOf(code);
  const starts = ["crate", "self", "super", ...children].join("|");
  return [...code.matchAll(new RegExp(`(?<![\\w:])(?:${starts})(?:::\\w+)+`, "g"))].flatMap(([found]) => {
    const absolute = absolutePath(found.split("::"), path, children);
    return absolute ? [absolute] : [];
  });
}

/**
 * Files that name a package which is not theirs to name, in code, in an attribute or in a text; comments may.
 * @param {Map<string, string>} sources
 * @param {import("./rooms.mjs").Rule[]} rules
 */
export function forbiddenNames(sources, rules) {
  return [...sources].flatMap(([file, text]) => {
    const code = bare(text, true);
    return rules.flatMap(({ places, packages }) =>
      packages
        .filter((name) => new RegExp(name, "i").test(code) && !places.some((place) => standsIn(file, place)))
        .map((name) => `${file} names ${name}`),
    );
  });
}

/** A folder has a mod.rs: foo.rs beside foo/ would be a second style. */
export function mixedModules(/** @type {string[]} */ files) {
  return files
    .filter((file) => files.some((other) => other.startsWith(`${file.replace(/\.rs$/, "")}/`)))
    .map((file) => `${file} stands beside a folder of its name`);
}
