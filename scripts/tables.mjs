// Tables that a command measures, in a page of docs: everything between two marks is the command's.
import { readFileSync, writeFileSync } from "node:fs";
import { Failure, output } from "./run.mjs";

const CARGO = ["run", "--release", "--quiet", "--package", "vcgpdm", "--example"];

/** The command of an example of the library. */
export const example = (/** @type {string} */ name, /** @type {string[]} */ ...asked) => [
  ...CARGO,
  name,
  "--",
  ...asked,
];

/** What an example of the library prints: tables. */
export function measured(/** @type {string} */ name, /** @type {string[]} */ ...asked) {
  const tables = output("cargo", ...example(name, ...asked));
  if (tables === null) throw new Failure(`the example ${name} failed`);
  return tables;
}

/** Puts the tables where the page has its marks of that name, in place of those of the last time. */
export function putTables(/** @type {string} */ page, /** @type {string} */ tables, name = "tables") {
  const [BEGIN, END] = [`<!-- ${name}: begin -->`, `<!-- ${name}: end -->`];
  const text = readFileSync(page, "utf8");
  const [begin, end] = [text.indexOf(BEGIN), text.indexOf(END)];
  if (begin < 0 || end < begin)
    throw new Failure(`${page} has no place for tables, between ${BEGIN} and ${END}`);
  writeFileSync(page, `${text.slice(0, begin + BEGIN.length)}\n\n${tables.trim()}\n\n${text.slice(end)}`);
  console.log(`the tables are in ${page}`);
}
