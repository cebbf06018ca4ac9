// `npm run comparison -- CLIP.bvh ...`: all models on these trials, each held out in turn, and what the papers say about them.
// The tables go into docs/comparison.md, the results to where the page finds them. Finished trainings are kept in
// target/comparison: stop and go on at will.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { at, Failure, main, output, run } from "./run.mjs";
import { putTables } from "./tables.mjs";

const folder = at("target/comparison");
const page = at("docs/comparison.md");
const shown = at("www/public/comparison/walks.results.json");
const program = at("target/release/vcgpdm");

/** Who is compared on what; each a run of `vcgpdm evaluate`. */
const SWEEPS = [
  ["--models", "vcgpdm,vgpdm,tmp,dmp-discrete,dmp-rhythmic", "--ips", "4,8,12,16,20", "--bases", "10,20,40"],
  ["--models", "map-gpdm,map-cgpdm"],
  ["--models", "map-gpdm,map-cgpdm", "--balanced"],
];
/** How time grows with the frames: one job at a time, so that none waits for another. */
const TIMES = [
  "--models",
  "vcgpdm,map-cgpdm",
  "--training-trials",
  "1,2,4,8",
  "--folds",
  "1",
  "--max-iterations",
  "100",
  "--threads",
  "1",
];

/** All results in one file, without the digits that nobody reads. */
function together(/** @type {string[]} */ files) {
  const read = files.map((file) => JSON.parse(readFileSync(file, "utf8")));
  const short = (/** @type {string} */ name, /** @type {unknown} */ value) =>
    typeof value === "number" && !Number.isInteger(value)
      ? Number(value.toPrecision(name === "bound" || name === "objective" ? 9 : 6))
      : value;
  return `${JSON.stringify({ ...read[0], finished: read.flatMap(({ finished }) => finished) }, short)}\n`;
}

await main(async () => {
  const clips = process.argv.slice(2);
  if (clips.length < 10) throw new Failure(`expected at least ten clips (.bvh), found ${clips.length}`);
  await run("cargo", "build", "--release", "--package", "vcgpdm-cli");
  mkdirSync(folder, { recursive: true });
  const [results, times] = [join(folder, "results.json"), join(folder, "times.json")];
  const common = ["evaluate", ...clips, "--parts", "lower,upper"];
  await run(program, ...common, ...TIMES, "--out", times);
  for (const sweep of SWEEPS) await run(program, ...common, ...sweep, "--out", results);
  mkdirSync(dirname(shown), { recursive: true });
  writeFileSync(shown, together([results, times]));
  const tables = output(program, "report", shown);
  if (tables === null) throw new Failure("the report could not be made");
  putTables(page, tables);
});
