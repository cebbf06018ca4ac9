// `npm run lab -- modularity`: a library that shares its walking primitive beside a model of each movement,
// primitives learned again under the pose maps of another library, and a combination that was never recorded, on
// made trials, into docs/modularity.md and docs/modularity.svg, which the page shows too, and the page's own copy of
// the tables. `npm run lab -- modularity imports` makes only the second table again, `combination` only the third.
import { readFileSync, writeFileSync } from "node:fs";
import { at, Failure } from "../run.mjs";
import { measured, putTables } from "./tables.mjs";

const PAGE = at("docs/modularity.md");
const PICTURE = at("docs/modularity.svg");
/** What the lesson on the page shows. */
const STORED = at("www/src/primitives/modularity.json");

/** The cells of a table of the docs. */
function cells(/** @type {string} */ name) {
  const text = readFileSync(PAGE, "utf8");
  const table = text.slice(text.indexOf(`<!-- ${name}: begin -->`), text.indexOf(`<!-- ${name}: end -->`));
  const lines = table.split("\n").filter((line) => line.startsWith("|") && !line.startsWith("|---"));
  const [head = [], ...rows] = lines.map((line) =>
    line
      .split("|")
      .slice(1, -1)
      .map((cell) => cell.trim()),
  );
  return { head, rows };
}

export async function modularity(/** @type {string | undefined} */ only) {
  const parts = ["imports", "combination"];
  if (only !== undefined && !parts.includes(only))
    throw new Failure(`expected ${parts.join(" or ")}, or nothing, found ${only}`);
  if (only === undefined) putTables(PAGE, measured("modularity", PICTURE));
  for (const part of parts) if (only === undefined || only === part) putTables(PAGE, measured(part), part);
  const stored = { modular: cells("tables"), imports: cells("imports"), combination: cells("combination") };
  writeFileSync(STORED, `${JSON.stringify(stored, null, 2)}\n`);
}
