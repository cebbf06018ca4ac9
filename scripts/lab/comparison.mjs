// `npm run lab -- comparison FOLDER ...`: compares all models on several subjects, each trial held out in turn,
// with each other and with the papers. Each folder holds the clips (.bvh) of one person or movement; the
// movements that the program makes come after them, or only those that are named (bottle-made). docs/comparison
// gets the results (NAME.json) and the tables (NAME.md); the page gets the results of the first folder. A finished
// training is never done again: delete docs/comparison/*.json to begin anew.
// --primary trains only what the primary claims need, for one table over all folders; with --from-2-frames all
// predictions of this table start as in the papers.
// --tables writes the tables again from the results, without the clips: only the folders' names are used.
// --quick trains with few trials, settings and iterations, to test the command, and writes no file of the project.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { compileTests } from "../cargo.mjs";
import { at, Failure, output, run } from "../run.mjs";
import { BOTTLE, MADE, PARTS, subject, THREE_PARTS } from "./subjects.mjs";
import { writeSections, writeTables } from "./tables.mjs";

const shown = at("www/public/comparison/walks.results.json");

/** The heading of the tables over all trials of a report, and its name in the documents. */
const TOGETHER = "### All together";
const RECORDED = "### Recorded trials together";

/** @typedef {import("./subjects.mjs").Subject} Subject */
/**
 * The MAP models have a limit of their own: they do not converge (docs/comparison/method.md), and each of their
 * iterations takes long.
 * @typedef {{ ips: string, poseIps: string, seatedPoseIps: string, seatedPrimitives: string, bases: string,
 * primitives: string, components: string, iterations: string, mapIterations: string, times: string }} Extent
 */

/** @type {Extent} */
const WHOLE = {
  ips: "5,10,20,30",
  poseIps: "5,10,20,30",
  seatedPoseIps: "5,8",
  seatedPrimitives: "2,4,6,8,10",
  bases: "5,10,15,25,40,60,80,100",
  primitives: "bound,2,4,6,8,10,12,15,20",
  components: "3,6,10,20",
  iterations: "3000",
  mapIterations: "400",
  times: "1,2,4,8",
};
/**
 * What many persons are compared with: few sizes. A report cuts all results to the sizes that all persons have.
 * @type {Extent}
 */
const PRIMARY = { ...WHOLE, ips: "5,10", poseIps: "5,10,20", primitives: "4,8,20" };
/** @type {Extent} */
const QUICK = {
  ips: "5,10",
  poseIps: "5,10",
  seatedPoseIps: "5,8",
  seatedPrimitives: "2,4",
  bases: "5,25,100",
  primitives: "2",
  components: "3,6",
  iterations: "20",
  mapIterations: "10",
  times: "1,2,3",
};

/** Predictions that start as in the papers. */
const FROM_TWO = { file: "-from-2-frames", start: ["--start-frames", "2"] };

/**
 * Who is compared on what, and in which file the results are kept: of one setting each. Only `secondary` claims need
 * some of them.
 */
const sweeps = (/** @type {Extent} */ extent) => [...every(extent), ...variants(extent)];

/** The models of the papers, and the rivals. */
const every = (/** @type {Extent} */ { ips, poseIps, bases, primitives, components, ...rest }) => [
  {
    file: "",
    options: [...["--models", "tmp,dmp-rhythmic,promp"], ...["--bases", bases, "--primitives", primitives]],
  },
  { file: "", secondary: true, options: ["--models", "dmp-discrete", "--bases", bases] },
  ...["1", "2", "3"].map((order) => ({
    file: "",
    /** An autoregression starts from as many frames. */
    order,
    options: ["--models", "ar", "--components", components, "--order", order],
  })),
  { file: "", secondary: true, options: ["--models", "tmp", "--normalised-time"] },
  {
    file: "",
    options: [
      "--models",
      "vcgpdm,vgpdm",
      "--ips",
      ips,
      "--pose-ips",
      poseIps,
      "--max-iterations",
      rest.iterations,
    ],
  },
  { file: "", options: ["--models", "map-gpdm,map-cgpdm", "--max-iterations", rest.mapIterations] },
  {
    file: "",
    secondary: true,
    options: ["--models", "map-gpdm,map-cgpdm", "--balanced", "--max-iterations", rest.mapIterations],
  },
  // Once, for the record: Wang et al. (2008) have one part.
  {
    file: "",
    secondary: true,
    options: ["--models", "map-gpdm", "--linear", "--max-iterations", rest.mapIterations],
  },
  {
    file: FROM_TWO.file,
    secondary: true,
    options: [
      ...["--models", "vcgpdm,vgpdm,tmp,dmp-rhythmic,promp,ar", "--ips", "10", ...FROM_TWO.start],
      ...["--max-iterations", rest.iterations],
    ],
  },
  {
    file: "-whole-cycles",
    secondary: true,
    options: ["--models", "dmp-discrete,dmp-rhythmic,promp", "--bases", bases, "--whole-cycles"],
  },
];

/**
 * Models of 10 + 10 inducing points in other forms: parts without couplings; a whole body with as many latent
 * dimensions and points as two parts; dynamics of another order.
 */
const variants = (/** @type {Extent} */ { iterations }) => {
  const trained = (/** @type {string[]} */ ...options) => ({
    file: "",
    options: [...options, "--max-iterations", iterations],
  });
  return [
    trained("--models", "vcgpdm", "--uncoupled", "--ips", "10"),
    trained("--models", "vgpdm", "--latent", "6", "--ips", "20"),
    ...["1", "3"].map((order) => ({
      ...trained("--models", "vcgpdm,vgpdm", "--order", order, "--ips", "10"),
      secondary: true,
    })),
  ];
};

/** Of a movement that is not periodic, with the sizes of Velychko et al. (2018, 5.3). MAP models would take hours. */
const seatedSweeps = (/** @type {Extent} */ { seatedPoseIps, seatedPrimitives, bases, iterations }) => {
  const sizes = ["--ips", "8", "--pose-ips", seatedPoseIps, "--max-iterations", iterations];
  const models = [
    ["--models", "vcgpdm,vgpdm", ...sizes],
    ["--models", "tmp,dmp-discrete", "--bases", bases, "--primitives", seatedPrimitives],
    ["--models", "tmp", "--primitives", "6", "--normalised-time"],
  ];
  return models.map((options) => ({ file: "", parts: THREE_PARTS, options }));
};

/**
 * How the time of an iteration and of a whole training grows with the frames: one job at a time, so that none waits
 * for another, of three seeds. The parts are those of all else, and the three of Velychko et al. (2017, supplement).
 */
const times = (/** @type {Extent} */ extent, /** @type {number} */ trials) => {
  // Fewer than the trials that all else is trained on: these are no results of a trial held out.
  const counts = extent.times.split(",").filter((count) => Number(count) < trials - 1);
  const options = (
    /** @type {string} */ models,
    /** @type {string} */ ips,
    /** @type {string} */ iterations,
  ) => [
    ...["--models", models, "--folds", "1", "--seeds", "0,1,2", "--training-trials", counts.join(",")],
    ...["--ips", ips, "--max-iterations", iterations, "--threads", "1"],
  ];
  const { iterations, mapIterations } = extent;
  return [
    // Settings of which there are no other trainings, measured while the machine did other things too.
    { file: "-times", parts: PARTS, options: options("vcgpdm", "12", iterations) },
    { file: "-times", parts: PARTS, options: options("map-cgpdm", "10", "100") },
    { file: "-three-parts", parts: THREE_PARTS, options: options("vcgpdm", "10", iterations) },
    { file: "-three-parts", parts: THREE_PARTS, options: options("map-cgpdm", "10", mapIterations) },
  ];
};

/**
 * Digits that are kept for the page, of the numbers of which differences are shown; of others, FEW.
 * @type {Record<string, number>}
 */
const DIGITS = { bound: 7, objective: 7, seconds: 2 };
const FEW = 4;

/** A number, or each of a list, without the digits that nobody reads. The page shows no details of predictions. */
function short(/** @type {string} */ name, /** @type {unknown} */ value) {
  if (name === "details") return undefined;
  const shortened = (/** @type {unknown} */ one) =>
    typeof one === "number" && !Number.isInteger(one) ? Number(one.toPrecision(DIGITS[name] ?? FEW)) : one;
  if (Array.isArray(value)) return value.map(shortened);
  // The numbers in a list are already short.
  return /^\d+$/.test(name) ? value : shortened(value);
}

/** Models of another order are compared in the documents alone. */
const isForPage = (/** @type {{ job: { candidate: { order?: number } } }} */ { job }) =>
  (job.candidate.order ?? 2) === 2;

/** The results in one file, as the page gets them. */
function together(/** @type {string[]} */ files) {
  const read = files.map((file) => JSON.parse(readFileSync(file, "utf8")));
  const finished = read.flatMap(({ finished }) => finished.filter(isForPage));
  return `${JSON.stringify({ ...read[0], finished }, short)}\n`;
}

export async function comparison(/** @type {string[]} */ ...words) {
  const quick = words.includes("--quick");
  const onlyTables = words.includes("--tables");
  const primary = words.includes("--primary");
  const names = words.filter((word) => !word.startsWith("--"));
  const all = [...MADE, BOTTLE];
  const asked = all.filter(({ name }) => names.includes(name));
  const made = primary ? [] : asked.length > 0 ? asked : all;
  const folders = names.filter((word) => !asked.some(({ name }) => name === word));
  const named = (/** @type {string} */ folder) => ({ name: basename(resolve(folder)), clips: [] });
  const recorded = folders.map((folder) => (onlyTables ? named(folder) : subject(folder)));
  const subjects = /** @type {Subject[]} */ ([...recorded, ...made]);
  if (new Set(subjects.map(({ name }) => name)).size < subjects.length)
    throw new Failure("expected folders of different names: they are the names of the subjects");
  const extent = quick ? QUICK : primary ? PRIMARY : WHOLE;
  const folder = at(quick ? "target/comparison-quick" : "docs/comparison");
  const program = at(quick ? "target/debug/vcgpdm" : "target/release/vcgpdm");
  if (quick) await compileTests();
  else await run("cargo", "build", "--release", "--package", "vcgpdm-cli");
  mkdirSync(folder, { recursive: true });
  const evaluate = async (
    /** @type {Subject} */ { name, clips },
    /** @type {{ file: string, parts?: string, options: string[] }} */ { file, parts = PARTS, options },
  ) => {
    const path = join(folder, `${name}${file}.json`);
    const trials = quick ? clips.slice(0, 3) : clips;
    if (!onlyTables) await run(program, "evaluate", ...trials, "--parts", parts, ...options, "--out", path);
    return path;
  };
  if (primary) {
    const files = [];
    const { file: suffix, start } = words.includes("--from-2-frames") ? FROM_TWO : { file: "", start: [] };
    // A file of its own: the tables of the first persons have one size from two frames.
    const file = suffix && `-primary${suffix}`;
    for (const one of recorded)
      for (const { options, ...sweep } of sweeps(extent))
        if (!("secondary" in sweep || (suffix && "order" in sweep && Number(sweep.order) > 2)))
          files.push(await evaluate(one, { file, options: [...options, ...start] }));
    const tables = output(program, "report", "--primary", ...new Set(files));
    if (tables === null) throw new Failure("the report could not be made");
    const title = suffix ? "Primary claims from two first frames" : "Primary claims";
    const command = `npm run lab -- comparison --primary${suffix && " --from-2-frames"}`;
    return writeTables(join(folder, `primary-claims${suffix}.md`), { title, command, tables });
  }
  const [first] = recorded;
  /** @type {string[]} */
  const timed = [];
  if (first) for (const one of times(extent, first.clips.length)) timed.push(await evaluate(first, one));
  const report = async (/** @type {Subject[]} */ some) => {
    const files = [];
    for (const one of some)
      for (const sweep of (one.seated ? seatedSweeps : sweeps)(extent))
        files.push(await evaluate(one, sweep));
    // The report puts the times of the first subject's trials together with its other results.
    if (some === recorded) files.push(...timed);
    const text = output(program, "report", ...new Set(files));
    if (text === null) throw new Failure("the report could not be made");
    // The report of a single set has no heading.
    return text.startsWith("### ") ? text : `### ${some[0]?.name}\n\n${text}`;
  };
  // Recorded and made trials are never put together.
  const reports = recorded.length > 0 ? [(await report(recorded)).replace(TOGETHER, RECORDED)] : [];
  const fromTwo = recorded.map(({ name }) => join(folder, `${name}${FROM_TWO.file}.json`));
  if (recorded.length > 1) {
    const [, all = ""] = (output(program, "report", ...fromTwo) ?? "").split(TOGETHER);
    reports.push(`${RECORDED} from 2 frames${all}`);
  }
  reports.push(...(await report(made)).split(TOGETHER).slice(0, 1));
  if (quick) return console.log(reports.join("\n"));
  if (first) {
    mkdirSync(dirname(shown), { recursive: true });
    const files = ["", "-times"].map((file) => join(folder, `${first.name}${file}.json`));
    writeFileSync(shown, together(files));
  }
  for (const sections of reports) writeSections(folder, "npm run lab -- comparison", sections);
}
