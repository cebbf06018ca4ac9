// `npm run comparison -- FOLDER ...`: all models on several subjects, each trial held out in turn, and what the papers say about them.
// Each folder holds the clips (.bvh) of one person or movement; the trials that the program makes itself come after them. The tables
// go into docs/comparison.md, the results of the first folder to where the page finds them. Finished trainings are kept in
// target/comparison: stop and go on at will. With --quick few settings and iterations, to see that it works; nothing is written then.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { at, Failure, main, output, run } from "./run.mjs";
import { putTables } from "./tables.mjs";

const page = at("docs/comparison.md");
const shown = at("www/public/comparison/walks.results.json");
const program = at("target/release/vcgpdm");

/** The movements of which the program makes trials. */
const MADE = [
  {
    name: "walk-made",
    clips: ["sample:walk-1", "sample:walk-2", "sample:walk-3", "sample:walk-4", "sample:walk-5", "sample:walk-6"],
  },
  {
    name: "walk-and-wave-made",
    clips: ["sample:walk-wave-1", "sample:walk-wave-2", "sample:walk-wave-3", "sample:walk-wave-4"],
  },
];

/** @typedef {{ name: string, clips: string[] }} Subject */
/** @typedef {{ ips: string, poseIps: string, bases: string, primitives: string, iterations: string, times: string }} Extent */

/** @type {Extent} */
const WHOLE = {
  ips: "5,10,20,30",
  poseIps: "10,20,30",
  bases: "5,10,15,25,40,60,80,100",
  primitives: "bound,2,4,6,8,10,12,15,20",
  iterations: "3000",
  times: "1,2,4,8",
};
/** @type {Extent} */
const QUICK = { ips: "5,10", poseIps: "8", bases: "5,25,100", primitives: "2,4", iterations: "20", times: "1,2,3" };

/** Who is compared on what, and in which file the results are kept: of one setting each. */
const sweeps = (/** @type {Extent} */ { ips, poseIps, bases, primitives, iterations }) => [
  { file: "", options: ["--models", "tmp,dmp-discrete,dmp-rhythmic", "--bases", bases, "--primitives", primitives] },
  { file: "", options: ["--models", "tmp", "--normalised-time"] },
  {
    file: "",
    options: ["--models", "vcgpdm,vgpdm", "--ips", ips, "--pose-ips", poseIps, "--max-iterations", iterations],
  },
  { file: "", options: ["--models", "map-gpdm,map-cgpdm", "--max-iterations", iterations] },
  { file: "", options: ["--models", "map-gpdm,map-cgpdm", "--balanced", "--max-iterations", iterations] },
  { file: "", options: ["--models", "map-gpdm,map-cgpdm", "--linear", "--max-iterations", iterations] },
  {
    file: "-from-2-frames",
    options: [
      ...["--models", "vcgpdm,vgpdm,tmp,dmp-rhythmic", "--ips", "10", "--start-frames", "2"],
      ...["--max-iterations", iterations],
    ],
  },
  {
    file: "-whole-cycles",
    options: ["--models", "dmp-discrete,dmp-rhythmic", "--bases", bases, "--whole-cycles"],
  },
];

/** How time grows with the frames: one job at a time, so that none waits for another. Three seeds are repeats. */
const times = (/** @type {Extent} */ extent, /** @type {number} */ trials) => [
  ...["--models", "vcgpdm,map-cgpdm", "--folds", "1", "--seeds", "0,1,2"],
  ...[
    "--training-trials",
    extent.times
      .split(",")
      .filter((count) => Number(count) < trials)
      .join(","),
  ],
  ...["--ips", "10", "--max-iterations", "100", "--threads", "1"],
];

/** The folder's clips as one subject. */
function subject(/** @type {string} */ folder) {
  const files = readdirSync(folder).filter((file) => file.toLowerCase().endsWith(".bvh"));
  if (files.length < 3) throw new Failure(`expected at least three clips (.bvh) in ${folder}, found ${files.length}`);
  return { name: basename(resolve(folder)), clips: files.sort().map((file) => join(folder, file)) };
}

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
  const words = process.argv.slice(2);
  const quick = words.includes("--quick");
  const folders = words.filter((word) => word !== "--quick");
  const subjects = /** @type {Subject[]} */ ([...folders.map(subject), ...MADE]);
  if (new Set(subjects.map(({ name }) => name)).size < subjects.length)
    throw new Failure("expected folders of different names: they are the names of the subjects");
  const extent = quick ? QUICK : WHOLE;
  const folder = at(quick ? "target/comparison-quick" : "target/comparison");
  await run("cargo", "build", "--release", "--package", "vcgpdm-cli");
  mkdirSync(folder, { recursive: true });
  /** @type {string[]} */
  const files = [];
  const evaluate = async (
    /** @type {Subject} */ { name, clips },
    /** @type {string} */ file,
    /** @type {string[]} */ options,
  ) => {
    const path = join(folder, `${name}${file}.json`);
    await run(program, "evaluate", ...clips, "--parts", "lower,upper", ...options, "--out", path);
    if (!files.includes(path)) files.push(path);
    return path;
  };
  const [first] = subjects;
  if (!first) throw new Failure("expected a subject");
  const timed = await evaluate(first, "-times", times(extent, first.clips.length));
  for (const one of subjects) for (const { file, options } of sweeps(extent)) await evaluate(one, file, options);
  // The times are of the first subject's trials: the report puts them together with its other results.
  const named = [...files.filter((file) => file !== timed), timed];
  const tables = output(program, "report", ...named);
  if (tables === null) throw new Failure("the report could not be made");
  if (quick) return console.log(tables);
  mkdirSync(dirname(shown), { recursive: true });
  writeFileSync(shown, together([join(folder, `${first.name}.json`), timed]));
  putTables(page, tables);
});
