// Which Rust files use each other, without a compiler: the order of the modules in tools/rust-imports/order.txt,
// circles between files, and the length of the files.
import { readFileSync } from "node:fs";
import { relative } from "node:path";
import { at, Failure, filesUnder } from "./run.mjs";

/** Lines of code of a file, without comments and empty lines. */
const MAX_LINES = 400;
/** Re-exports of re-exports are followed this far. */
const MAX_DEPTH = 8;
/** Comments, texts, characters, lifetimes, visibility within the crate, words, and signs. */
const TOKENS =
  /\/\/[^\n]*|\/\*.*?\*\/|\b[bc]*r(#*)".*?"\1|"(?:\\.|[^"\\])*"|'(?:\\[^\n']+|\\'|[^\\'])'|'\w+|pub\s*\((?:crate|super|self|in\s[^)]*)\)|\w+|::|\.\.|\S/gs;

/**
 * What a file names: paths from the root of the crate. `name`: that of an import. `test`: for tests alone.
 * @typedef {{ path: string[], test: boolean, name?: string, isPublic?: boolean }} Mention
 * `words`: names in product code that may be those of imports. `testModules`: modules of tests in other files.
 * @typedef {{ file: string, module: string[], mentions: Mention[], words: Set<string>, testModules: string[] }} Source
 * Modules by line; a module uses only modules of earlier lines. No lines: every order is allowed.
 * `within`: a module whose own modules these are, as in "crate/a models"; only product code keeps that order.
 * @typedef {{ folder: string, within: string, lines: string[][] }} Order
 */

const idOf = (/** @type {string[]} */ path) => path.join("::");

/** The place of the bracket that closes the one at `open`, or of what ends the item that begins at `open`. */
function endOf(/** @type {string[]} */ code, /** @type {number} */ open) {
  let depth = 0;
  for (let i = open; i < code.length; i++) {
    const token = code[i] ?? "";
    if ("([{".includes(token)) depth++;
    else if (")]}".includes(token) && --depth === 0 && (token === "}" || "([".includes(code[open] ?? "")))
      return i;
    else if (token === ";" && depth === 0) return i;
  }
  return code.length;
}

/** The imports of a tree such as `a::{b, c as d}`. @returns {{ path: string[], name: string }[]} */
function importsOf(/** @type {string[]} */ tree, /** @type {string[]} */ before = []) {
  const open = tree.indexOf("{");
  if (open >= 0) {
    const prefix = [...before, ...tree.slice(0, open).filter((token) => token !== "::")];
    /** @type {string[][]} */
    const branches = [[]];
    let depth = 0;
    for (const token of tree.slice(open + 1, -1)) {
      depth += Number(token === "{") - Number(token === "}");
      if (token === "," && depth === 0) branches.push([]);
      else branches.at(-1)?.push(token);
    }
    return branches.filter(({ length }) => length > 0).flatMap((branch) => importsOf(branch, prefix));
  }
  const [own, name] = tree.includes("as") ? [tree.slice(0, -2), tree.at(-1)] : [tree, undefined];
  const path = [...before, ...own.filter((token) => token !== "::")];
  if (path.length > 1 && path.at(-1) === "self") path.pop();
  return [{ path, name: name ?? path.at(-1) ?? "" }];
}

/** Reads a file below `src`, such as `gp/psi/mod.rs`. @returns {Source} */
export function parse(/** @type {string} */ file, /** @type {string} */ text) {
  const code = [...text.matchAll(TOKENS)].map(([token]) => (/^pub\s*\(/.test(token) ? "pub" : token));
  const module = file.replace(/\.rs$/, "").split("/");
  if (["mod", "lib", "main"].includes(module.at(-1) ?? "")) module.pop();
  /** @type {Source} */
  const source = { file, module, mentions: [], words: new Set(), testModules: [] };
  const tokens = code.filter((token) => !/^(\/[/*]|[bc]*r#*"|"|'.)/.test(token));
  /** The modules that are declared in this file; the first reading finds them. @type {Set<string>} */
  const children = new Set();
  for (const isFirst of [true, false]) {
    /** The modules that the place is in. @type {{ name: string, end: number }[]} */
    let inside = [];
    let testEnd = -1;
    for (let i = 0; i < tokens.length; i++) {
      inside = inside.filter(({ end }) => i <= end);
      const place = [...module, ...inside.map(({ name }) => name)];
      const [token = "", next = ""] = tokens.slice(i, i + 2);
      const test = i <= testEnd;
      const add = (/** @type {string[]} */ path, /** @type {Partial<Mention>} */ rest = {}) => {
        const [first = ""] = path;
        if (!test && !rest.name) source.words.add(first);
        const ups = path.filter((segment) => segment === "super").length;
        /** @type {string[] | null} */
        let whole = null;
        if (first === "crate") whole = path.slice(1);
        else if (first === "self") whole = [...place, ...path.slice(1)];
        else if (ups > 0) whole = [...place.slice(0, place.length - ups), ...path.slice(ups)];
        // A word of its own may be a variable with the name of a module.
        else if ((rest.name || path.length > 1) && children.has(idOf([...place, first])))
          whole = [...place, ...path];
        if (whole && !isFirst) source.mentions.push({ path: whole, test, ...rest });
      };
      if (token === "#" && (next === "[" || next === "!")) {
        const end = endOf(tokens, tokens.indexOf("[", i));
        if (tokens.slice(i, end + 1).join("") === "#[cfg(test)]")
          testEnd = Math.max(testEnd, endOf(tokens, end + 1));
        i = end;
      } else if (token === "mod") {
        children.add(idOf([...place, next]));
        if (tokens[i + 2] === "{") inside.push({ name: next, end: endOf(tokens, i + 2) });
        else if (test && !isFirst) source.testModules.push(idOf([...place, next]));
        i += 2;
      } else if (token === "use" && next !== "<") {
        const end = tokens.indexOf(";", i);
        const isPublic = tokens[i - 1] === "pub";
        for (const { path, name } of importsOf(tokens.slice(i + 1, end))) add(path, { name, isPublic });
        i = end;
      } else if (/^[a-z_]/i.test(token) && ![".", "::"].includes(tokens[i - 1] ?? "")) {
        const path = [token];
        for (; tokens[i + 1] === "::" && /^\w/.test(tokens[i + 2] ?? ""); i += 2)
          path.push(tokens[i + 2] ?? "");
        add(path);
      }
    }
  }
  return source;
}

/** All uses, "from > to"; without `tests` those of product code. */
export function usesOf(/** @type {Source[]} */ sources, /** @type {boolean} */ tests) {
  const modules = new Map(sources.map((source) => [idOf(source.module), source]));
  const testModules = sources.flatMap((source) => source.testModules);
  /** The file that defines what a path names: a re-export leads on to its origin. @returns {Source | undefined} */
  function fileOf(/** @type {string[]} */ path, depth = 0) {
    let length = path.length;
    while (length > 0 && !modules.has(idOf(path.slice(0, length)))) length--;
    const source = modules.get(idOf(path.slice(0, length)));
    const reExport = source?.mentions.find(
      ({ name, test }) => name !== undefined && name === path[length] && !test,
    );
    if (!reExport || depth === MAX_DEPTH) return source;
    return fileOf([...reExport.path, ...path.slice(length + 1)], depth + 1);
  }
  /** @type {Set<string>} */
  const uses = new Set();
  for (const { file, module, mentions, words } of sources) {
    const isTest = testModules.some((name) => `${idOf(module)}::`.startsWith(`${name}::`));
    for (const { path, test, name, isPublic } of mentions) {
      if (!tests && (test || isTest)) continue;
      // A re-export of a name from below is a use only where the file needs the name itself.
      const isFromBelow = isPublic && module.every((segment, k) => path[k] === segment);
      if (name && isFromBelow && !words.has(name)) continue;
      const to = fileOf(path.at(-1) === "*" ? path.slice(0, -1) : path);
      if (to && to.file !== file) uses.add(`${file} > ${to.file}`);
    }
  }
  return [...uses].sort();
}

/** Circles of files that use each other; each begins and ends with the same file. */
export function circles(/** @type {string[]} */ uses) {
  /** @type {Map<string, string[]>} */
  const next = new Map();
  for (const [from = "", to = ""] of uses.map((use) => use.split(" > ")))
    next.set(from, [...(next.get(from) ?? []), to]);
  const done = new Set();
  /** @type {string[]} */
  const found = [];
  const visit = (/** @type {string} */ file, /** @type {string[]} */ path) => {
    if (path.includes(file)) return void found.push([...path.slice(path.indexOf(file)), file].join(" -> "));
    if (done.has(file)) return;
    for (const used of next.get(file) ?? []) visit(used, [...path, file]);
    done.add(file);
  };
  for (const file of next.keys()) visit(file, []);
  return found;
}

/** Reads `order.txt`: a crate begins at the margin, its modules are indented. `#` begins a comment. */
export function ordersOf(/** @type {string} */ text) {
  /** @type {Order[]} */
  const orders = [];
  for (const line of text.replace(/#.*/g, "").split("\n")) {
    const [folder = "", within = ""] = line.trim().split(/ +/);
    if (/^\S/.test(line)) orders.push({ folder, within, lines: [] });
    else if (line.trim()) orders.at(-1)?.lines.push(line.split(",").map((name) => name.trim()));
  }
  return orders;
}

/** Modules without a line in the order, and uses of a module on the same line or on a later one. */
export function offencesOf(
  /** @type {Order} */ { within, lines },
  /** @type {string[]} */ allFiles,
  /** @type {string[]} */ allUses,
) {
  if (lines.length === 0) return [];
  const inside = within ? `${within}/` : "";
  const isRoot = (/** @type {string} */ file) => ["lib.rs", `${within}/mod.rs`].includes(file);
  const files = allFiles.filter((file) => file.startsWith(inside));
  const uses = allUses.filter((use) => use.split(" > ").every((file) => file.startsWith(inside)));
  const moduleOf = (/** @type {string} */ file) => file.slice(inside.length).replace(/(\/.*|\.rs)$/, "");
  const lineOf = (/** @type {string} */ file) => lines.findIndex((names) => names.includes(moduleOf(file)));
  const strange = files.filter((file) => !isRoot(file) && lineOf(file) < 0).map(moduleOf);
  const against = uses.filter((use) => {
    const [from = "", to = ""] = use.split(" > ");
    if (isRoot(from) || moduleOf(from) === moduleOf(to)) return false;
    return lineOf(to) < 0 || lineOf(from) <= lineOf(to);
  });
  return [
    ...[...new Set(strange)].map((name) => `${name} is missing in order.txt`),
    ...against.map((use) => `${use.replace(" > ", " uses ")}, against order.txt`),
  ];
}

export const linesOfCode = (/** @type {string} */ text) =>
  text.split("\n").filter((line) => !/^\s*(\/\/.*)?$/.test(line)).length;

/** Throws when a crate of `order.txt` is against the order, has a circle, or a file that is too long. */
export function checkRustImports() {
  /** @type {string[]} */
  const offences = [];
  for (const order of ordersOf(readFileSync(at("tools/rust-imports/order.txt"), "utf8"))) {
    const own = filesUnder([at(order.folder)]).filter((file) => file.endsWith(".rs"));
    const texts = own.map((file) => ({
      file: relative(at(order.folder), file).replaceAll("\\", "/"),
      text: readFileSync(file, "utf8"),
    }));
    const inSrc = texts.filter(({ file }) => file.startsWith("src/"));
    const sources = inSrc.map(({ file, text }) => parse(file.slice(4), text));
    const files = sources.map(({ file }) => file);
    const long = texts.filter(({ text }) => linesOfCode(text) > MAX_LINES);
    const found = [
      ...offencesOf(order, files, usesOf(sources, order.within === "")),
      ...circles(usesOf(sources, false)),
      ...long.map(({ file, text }) => `${file}: ${linesOfCode(text)} lines, at most ${MAX_LINES}`),
    ];
    offences.push(...found.map((offence) => `${order.folder}: ${offence}`));
  }
  if (offences.length > 0) throw new Failure(offences.join("\n"));
}
