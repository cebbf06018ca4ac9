// `npm run golden`: computes the golden cases again with the independent implementation in tests/golden/generator (Python with
// JAX, installed into .tools/golden) and compares. `npm run golden -- CASE.json ...` checks other cases;
// `npm run golden -- --out FOLDER [--case K ...] [--seed S]` makes new ones.
import { existsSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { at, env, Failure, main, output, run, step, whenChanged } from "./run.mjs";

const generator = at("tests/golden/generator");
const requirements = join(generator, "requirements.txt");
const environment = at(".tools/golden");
const python =
  process.platform === "win32" ? join(environment, "Scripts", "python.exe") : join(environment, "bin", "python");

/** The Python of the machine that the environment is made with, and its version. */
function systemPython() {
  const ask = "import sys; print(sys.version_info >= (3, 10), sys.version.split()[0])";
  const older = [];
  for (const program of ["python3", "python", "py"]) {
    const [enough, version] = output(program, "-c", ask)?.split(" ") ?? [];
    if (enough === "True" && version) return { program, version };
    if (version) older.push(version);
  }
  const found = older.length > 0 ? `found only ${older.join(", ")}` : "found none";
  throw new Failure(`the golden cases need Python 3.10 or later, ${found}: https://www.python.org`);
}

async function installPackages() {
  const { program, version } = systemPython();
  return whenChanged("golden", { inputs: [requirements], outputs: [python], salt: version }, async () => {
    try {
      await run(program, "-m", "venv", "--clear", environment);
    } catch {
      throw new Failure(
        `Python ${version} could not make a virtual environment in .tools/golden; on Debian and Ubuntu the package python3-venv may be missing`,
      );
    }
    try {
      await run(python, "-m", "pip", "install", "--disable-pip-version-check", "--requirement", requirements);
    } catch {
      throw new Failure(
        `the packages in tests/golden/generator/requirements.txt could not be installed: no network, or none are made for Python ${version} on this machine`,
      );
    }
  });
}

/** Runs one of the generator's programs. JAX keeps what it has compiled, which takes longer than computing. */
function runGenerator(/** @type {string} */ program, /** @type {string[]} */ ...args) {
  env.JAX_COMPILATION_CACHE_DIR = join(environment, "compiled");
  env.PYTHONDONTWRITEBYTECODE = "1";
  return run(python, join(generator, program), ...args);
}

/** Whether `npm run golden` has installed everything. */
const installed = () => existsSync(python) && output(python, "-c", "import jax") !== null;

/** Checks the golden cases where the Python packages are installed already; returns a note of what was done. */
export async function checkGolden() {
  if (!installed()) return "skipped: Python with JAX is not installed in .tools/golden (npm run golden does it)";
  await runGenerator("check.py");
  return "the independent implementation agrees";
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: { out: { type: "string" }, case: { type: "string", multiple: true }, seed: { type: "string" } },
    });
    const { out, case: cases = [], seed } = values;
    if (out === undefined && (cases.length > 0 || seed !== undefined))
      throw new Failure("--case and --seed belong to --out FOLDER, which makes new cases");
    if (out !== undefined && positionals.length > 0)
      throw new Failure("either --out FOLDER makes new cases, or files are checked");
    await step("Python packages in .tools/golden", installPackages);
    if (out === undefined) await step("golden numbers", () => runGenerator("check.py", ...positionals));
    else {
      const choices = [
        ...cases.flatMap((number) => ["--case", number]),
        ...(seed === undefined ? [] : ["--seed", seed]),
      ];
      await step("new golden cases", () => runGenerator("make_golden.py", out, ...choices));
    }
  });
}
