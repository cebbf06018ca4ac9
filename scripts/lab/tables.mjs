// Tables that a command measures, in a page of docs: everything between two marks is the command's.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { Failure, output, run } from "../run.mjs";

const PROGRAM = ["run", "--release", "--quiet", "--package", "vcgpdm-lab", "--example", "lab", "--"];

/** Runs a measurement of the crate lab, which prints its tables. */
export const printTables = (/** @type {string[]} */ ...words) => run("cargo", ...PROGRAM, ...words);

/** The tables that a measurement of the crate lab prints. */
export function measured(/** @type {string[]} */ ...words) {
  const tables = output("cargo", ...PROGRAM, ...words);
  if (tables === null) throw new Failure(`the measurement ${words.join(" ")} failed`);
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

/** Writes tables to a file of their own, in place of the last ones. */
export function writeTables(
  /** @type {string} */ file,
  /** @type {{ title: string, command: string, tables: string }} */ { title, command, tables },
) {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `# ${title}\n\nWritten by \`${command}\`.\n\n${tables.trim()}\n`);
  console.log(`the tables are in ${file}`);
}

/** Writes each section of a report, headed `### NAME`, to the file `name.md` of the folder. */
export function writeSections(
  /** @type {string} */ folder,
  /** @type {string} */ command,
  /** @type {string} */ report,
) {
  const sections = report.split(/^### /m).slice(1);
  if (sections.length === 0) throw new Failure("expected a report with headings (###), found none");
  for (const section of sections) {
    const [title = "", ...lines] = section.split("\n");
    const file = join(folder, `${title.toLowerCase().replaceAll(" ", "-")}.md`);
    writeTables(file, { title, command, tables: lines.join("\n") });
  }
}
