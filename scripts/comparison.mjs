// `npm run comparison -- CLIP.bvh ...`: all models on these trials, each held out in turn, and what the papers say about them;
// the tables go into docs/comparison.md. Finished trainings are kept in target/comparison: stop and go on at will.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { at, Failure, main, output, run } from "./run.mjs";

const folder = at("target/comparison");
const page = at("docs/comparison.md");
const program = at("target/release/vcgpdm");
const [BEGIN, END] = ["<!-- tables: begin -->", "<!-- tables: end -->"];

/** Who is compared on what; each a run of `vcgpdm evaluate`. */
const SWEEPS = [
  ["--models", "vcgpdm,vgpdm,tmp,dmp-discrete,dmp-rhythmic", "--ips", "4,8,12,16,20", "--bases", "10,20,40"],
  ["--models", "map-gpdm,map-cgpdm"],
  ["--models", "map-gpdm,map-cgpdm", "--balanced"],
];
/** How time grows with the frames: one job at a time, so that none waits for another. */
const TIMES = ["--models", "vcgpdm,map-cgpdm", "--training-trials", "1,2,4,8", "--folds", "1", "--max-iterations", "100", "--threads", "1"];

await main(async () => {
  const clips = process.argv.slice(2);
  if (clips.length < 10) throw new Failure(`expected at least ten clips (.bvh), found ${clips.length}`);
  await run("cargo", "build", "--release", "--features", "cli");
  mkdirSync(folder, { recursive: true });
  const [results, times] = [join(folder, "results.json"), join(folder, "times.json")];
  const common = ["evaluate", ...clips, "--parts", "lower,upper"];
  await run(program, ...common, ...TIMES, "--out", times);
  for (const sweep of SWEEPS) await run(program, ...common, ...sweep, "--out", results);
  const tables = output(program, "report", results, times);
  if (tables === null) throw new Failure("the report could not be made");
  const text = readFileSync(page, "utf8");
  const [begin, end] = [text.indexOf(BEGIN), text.indexOf(END)];
  if (begin < 0 || end < begin) throw new Failure(`${page} has no place for tables, between ${BEGIN} and ${END}`);
  writeFileSync(page, `${text.slice(0, begin + BEGIN.length)}\n\n${tables.trim()}\n\n${text.slice(end)}`);
  console.log(`the tables are in ${page}`);
});
