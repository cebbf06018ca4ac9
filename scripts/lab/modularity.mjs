// `npm run lab -- modularity`: a library that shares its walking primitive beside a model of each movement, and
// primitives learned again under the pose maps of another library, on the sample trials, into
// docs/modularity.md and docs/modularity.svg, which the page shows too, and the page's own copy of the
// tables. `npm run lab -- modularity imports` makes only the second table again.
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
  if (only !== undefined && only !== "imports")
    throw new Failure(`expected imports, or nothing, found ${only}`);
  if (only === undefined) putTables(PAGE, measured("modularity", PICTURE));
  putTables(PAGE, measured("imports"), "imports");
  writeFileSync(
    STORED,
    `${JSON.stringify({ modular: cells("tables"), imports: cells("imports") }, null, 2)}\n`,
  );
}
