// The size of the project: lines of product and of tests, and files. A change that makes it larger also raises the
// budget, so that its reviewer sees the growth.
import { readFileSync } from "node:fs";
import { budget } from "./budget.mjs";
import { at, Failure, output } from "./run.mjs";

const SOURCE = /\.(rs|ts|js|mjs|cjs|css|py|pyi|html)$/;
const TEST = /\.test\.|\/tests\/|^tests\/|tests\.rs$|test_|\.fake/;
/** This module measures a test of the papers. */
const PRODUCT = "crate/lab/src/evaluation/modularity_test.rs";

/** The number of lines of the test items in a Rust file: of what follows `#[cfg(test)]`. */
function testLines(/** @type {string[]} */ lines) {
  let count = 0;
  for (let i = 0; i < lines.length; i++) {
    if (!/^\s*#\[cfg\((all\()?test/.test(lines[i] ?? "")) continue;
    let item = i + 1;
    while (/^\s*#\[/.test(lines[item] ?? "")) item++;
    const first = lines[item] ?? "";
    if (!/^\s*(pub(\(.*\))? )?(mod|fn|impl|use|struct|const|static)\b/.test(first)) continue;
    let end = item;
    const isOpen = first.includes("{") ? !first.trimEnd().endsWith("}") : !first.trimEnd().endsWith(";");
    const close = `${first.slice(0, first.length - first.trimStart().length)}}`;
    if (isOpen) for (end++; end < lines.length && !lines[end]?.startsWith(close); ) end++;
    count += end + 1 - i;
    i = end;
  }
  return count;
}

/** Counts the lines of the files that Git knows. */
function count() {
  const sizes = { product: 0, tests: 0, files: 0 };
  for (const file of (output("git", "ls-files") ?? "").split("\n").filter((file) => SOURCE.test(file))) {
    const lines = readFileSync(at(file), "utf8").replace(/\n$/, "").split("\n");
    const isTest = TEST.test(file) && file !== PRODUCT;
    const tests = isTest ? lines.length : file.endsWith(".rs") ? testLines(lines) : 0;
    sizes.files++;
    sizes.tests += tests;
    sizes.product += lines.length - tests;
  }
  return sizes;
}

/** Throws when the project is larger than its budget; returns the sizes as a note. */
export function checkLines() {
  if (output("git", "rev-parse", "HEAD") === null) return "skipped: not a checkout of Git";
  const sizes = count();
  const kinds = /** @type {const} */ (["product", "tests", "files"]);
  const note = `${sizes.product} lines of product, ${sizes.tests} of tests, ${sizes.files} files`;
  const over = kinds.filter((kind) => sizes[kind] > budget.lines[kind]);
  const limits = over.map((kind) => `${kind}: ${budget.lines[kind]}`).join(", ");
  if (over.length > 0) throw new Failure(`${note}: more than the budget in scripts/budget.mjs (${limits})`);
  return note;
}
