// Python environments of the project in .tools, each with the exact packages of its list.
import { existsSync } from "node:fs";
import { join } from "node:path";
import { at, Failure, output, run, whenChanged } from "./run.mjs";

/** The machine's Python, which makes the environments, and its version. */
function systemPython() {
  const ask = "import sys; print(sys.version_info >= (3, 10), sys.version.split()[0])";
  const older = [];
  for (const program of ["python3", "python", "py"]) {
    const [enough, version] = output(program, "-c", ask)?.split(" ") ?? [];
    if (enough === "True" && version) return { program, version };
    if (version) older.push(version);
  }
  const found = older.length > 0 ? `found only ${older.join(", ")}` : "found none";
  throw new Failure(`Python 3.10 or later is needed, ${found}: https://www.python.org`);
}

/** The environment with this name, and its Python. */
export function environment(/** @type {string} */ name) {
  const folder = at(".tools", name);
  const bin = process.platform === "win32" ? join(folder, "Scripts") : join(folder, "bin");
  const python = join(bin, process.platform === "win32" ? "python.exe" : "python");
  /** Whether the environment can load a module. */
  const has = (/** @type {string} */ module) =>
    existsSync(python) && output(python, "-c", `import ${module}`) !== null;
  return { folder, bin, python, has };
}

/**
 * Makes the environment with the packages in the list, unless it exists.
 * @param {string} name
 * @param {string} requirements a file as `pip install --requirement` reads it
 */
export async function install(name, requirements) {
  const { program, version } = systemPython();
  const { folder, python } = environment(name);
  return whenChanged(name, { inputs: [requirements], outputs: [python], salt: version }, async () => {
    try {
      await run(program, "-m", "venv", "--clear", folder);
    } catch {
      throw new Failure(
        `Python ${version} could not make a virtual environment in .tools/${name}; ` +
          "on Debian and Ubuntu the package python3-venv may be missing",
      );
    }
    const pip = [
      "-m",
      "pip",
      "install",
      "--quiet",
      "--disable-pip-version-check",
      "--requirement",
      requirements,
    ];
    try {
      await run(python, ...pip);
    } catch {
      throw new Failure(
        `the packages in ${requirements} could not be installed: no network, ` +
          `or none exist for Python ${version} on this machine`,
      );
    }
  });
}
