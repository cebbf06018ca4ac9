// `npm run golden`: computes the golden cases again with the independent implementation in
// tests/golden/generator (Python with JAX, installed into .tools/golden) and compares them.
// `npm run golden -- CASE.json ...` checks other cases. `npm run golden -- --out FOLDER [--case K ...]
// [--seed S] [--movements | --stored]` makes new ones.
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { environment, install } from "./python.mjs";
import { at, env, Failure, main, run, step } from "./run.mjs";

const generator = at("tests/golden/generator");
const requirements = join(generator, "requirements.txt");
const { folder, python, has } = environment("golden");

/**
 * Runs one of the generator's programs. The cache of JAX saves the compiling, which takes longer than the
 * computing.
 */
function runGenerator(/** @type {string} */ program, /** @type {string[]} */ ...args) {
  env.JAX_COMPILATION_CACHE_DIR = join(folder, "compiled");
  env.PYTHONDONTWRITEBYTECODE = "1";
  return run(python, join(generator, program), ...args);
}

/**
 * Checks the golden cases if the Python packages are installed; returns a note about the result.
 */
export async function checkGolden() {
  if (!has("jax"))
    return "skipped: Python with JAX is not installed in .tools/golden (npm run golden does it)";
  await runGenerator("check.py");
  return "the independent implementation agrees";
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: {
        out: { type: "string" },
        case: { type: "string", multiple: true },
        seed: { type: "string" },
        movements: { type: "boolean", default: false },
        stored: { type: "boolean", default: false },
      },
    });
    const { out, case: cases = [], seed, movements, stored } = values;
    if (movements && stored) throw new Failure("either --movements or --stored");
    if (out === undefined && (cases.length > 0 || seed !== undefined || movements || stored))
      throw new Failure(
        "--case, --seed, --movements and --stored belong to --out FOLDER, which makes new cases",
      );
    if (out !== undefined && positionals.length > 0)
      throw new Failure("either --out FOLDER makes new cases, or files are checked");
    await step("Python packages in .tools/golden", () => install("golden", requirements));
    if (out === undefined) await step("golden numbers", () => runGenerator("check.py", ...positionals));
    else {
      const choices = [
        ...cases.flatMap((number) => ["--case", number]),
        ...(seed === undefined ? [] : ["--seed", seed]),
        ...(movements ? ["--movements"] : []),
        ...(stored ? ["--stored"] : []),
      ];
      await step("new golden cases", () => runGenerator("make_golden.py", out, ...choices));
    }
  });
}
