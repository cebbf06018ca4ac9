// `npm run lab -- completing FOLDER ...`: each part of every trial held out is inferred from its other parts, and
// rollouts start from observed frames. Each folder holds the clips (.bvh) of one person; the sample movements of
// the program come after them. The tables go into docs/completing.md. target/completing keeps the results: a
// finished trial is never computed again, and deleting the folder begins anew.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { at, Failure, output, run } from "../run.mjs";
import { BOTTLE, MADE, PARTS, subject, THREE_PARTS } from "./subjects.mjs";
import { putTables } from "./tables.mjs";

const program = at("target/release/vcgpdm");
const page = at("docs/completing.md");
const SETTINGS = ["--ips", "20", "--pose-ips", "30", "--balanced"];

/** The lines of a report from the table with this heading to the next empty line. */
function tableOf(/** @type {string} */ report, /** @type {string} */ heading) {
  const from = report.indexOf(heading);
  if (from < 0) throw new Failure(`expected a table ${heading} in the report`);
  const begin = report.lastIndexOf("\n", from) + 1;
  return report.slice(begin, report.indexOf("\n\n", begin));
}

export async function completing(/** @type {string[]} */ ...folders) {
  const walks = [...folders.map(subject), ...MADE].map((one) => ({ ...one, parts: PARTS }));
  await run("cargo", "build", "--release", "--package", "vcgpdm-cli");
  const results = at("target/completing");
  mkdirSync(results, { recursive: true });
  const report = (/** @type {string[]} */ files) => {
    const text = output(program, "report", ...files);
    if (text === null) throw new Failure("the report could not be made");
    return text;
  };
  /** @type {string[]} */
  const completed = [];
  const starts = [];
  for (const { name, clips, parts } of [...walks, { ...BOTTLE, parts: THREE_PARTS }]) {
    const evaluate = async (/** @type {string} */ file, /** @type {string[]} */ ...options) => {
      const out = join(results, file);
      await run(program, "evaluate", ...clips, "--parts", parts, ...SETTINGS, ...options, "--out", out);
      return out;
    };
    completed.push(await evaluate(`${name}.json`, "--task", "complete"));
    const start = await evaluate(`${name}-start.json`, "--models", "vcgpdm,vgpdm", "--observed-start");
    const lines = tableOf(report([start]), "first frames trained on").split("\n");
    const [heading = "", line = "", ...rows] = lines;
    if (starts.length === 0) starts.push(`| trials ${heading}`, `|---${line}`);
    starts.push(...rows.map((row) => `| ${name} ${row}`));
  }
  putTables(page, report(completed));
  putTables(page, starts.join("\n"), "starts");
}
