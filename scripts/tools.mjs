// Checks rustup and Node, and installs the other tools that are missing.
import { readFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { at, env, executable, Failure, filesUnder, output, run, step, whenChanged, which } from "./run.mjs";

const NODE = [20, 19];

/** Whether version a is older than version b. */
const older = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
  const i = b.findIndex((n, k) => (a[k] ?? 0) !== n);
  return i >= 0 && (a[i] ?? 0) < (b[i] ?? 0);
};
const numbers = (/** @type {string} */ text) =>
  (text.match(/\d+(\.\d+)*/)?.[0] ?? "0").split(".").map(Number);

/** The oldest Rust that the packages promise to compile with. */
export function oldestRust() {
  const version = readFileSync(at("Cargo.toml"), "utf8").match(/rust-version = "([\d.]+)"/)?.[1];
  if (!version) throw new Failure("Cargo.toml names no rust-version");
  return version;
}

async function rust() {
  if (older(numbers(process.version), NODE))
    throw new Failure(
      `Node ${NODE.join(".")} or later is needed, this is ${process.version}: https://nodejs.org`,
    );
  if (output("rustup", "--version") === null)
    throw new Failure("rustup is needed and was not found: https://rustup.rs");
  if (output("rustc", "--version") === null) await run("rustup", "toolchain", "install", "stable");
  const needed = oldestRust();
  const have = output("rustc", "--version") ?? "";
  if (older(numbers(have), numbers(needed)))
    throw new Failure(`Rust ${needed} or later is needed, this is ${have}: rustup update stable`);
}

/** Adds missing targets or components to the toolchain. */
async function toolchain(/** @type {"target" | "component"} */ kind, /** @type {string[]} */ ...names) {
  const installed = output("rustup", kind, "list", "--installed") ?? "";
  const missing = names.filter(
    (name) => !installed.split(/\s+/).some((line) => line === name || line.startsWith(`${name}-`)),
  );
  if (missing.length > 0) await run("rustup", kind, "add", ...missing);
  return missing.length > 0 ? undefined : "there";
}

/** Installs what the lock file of a folder names; without a folder, that of the project. */
export function installNpmPackages(folder = "") {
  const files = ["package.json", "package-lock.json", ...(folder ? [] : ["www/package.json"])];
  const inputs = filesUnder(files.map((file) => at(folder, file)));
  const outputs = [at(folder, "node_modules", ".package-lock.json")];
  return whenChanged(join("npm", folder), { inputs, outputs }, async () => {
    // npm is a script on Windows and a program elsewhere; npm itself names its file when it runs us.
    const npm = process.env.npm_execpath;
    const ci = ["ci", "--prefix", at(folder)];
    await (npm ? run(process.execPath, npm, ...ci) : run("npm", ...ci));
  });
}

/** Compiles a program of crates.io into .tools, unless it is on the PATH, and puts it there. */
export async function installCargoTool(/** @type {string} */ name, /** @type {string} */ version) {
  if (which(name)) return "there";
  const folder = at(".tools", name);
  const program = join(folder, "bin", name + executable);
  env.PATH = [join(folder, "bin"), env.PATH].join(delimiter);
  return whenChanged(name, { inputs: [], outputs: [program], salt: version }, () =>
    run("cargo", "install", name, "--version", version, "--locked", "--debug", "--root", folder),
  );
}

/**
 * Installs the tools of the build; with `forTests` also those of the tests. `meanwhile` runs while npm waits
 * for the network, so it must not need the npm packages.
 * @param {{ forTests?: boolean, meanwhile?: () => Promise<unknown> }} [options]
 */
export async function installTools({ forTests = false, meanwhile } = {}) {
  await step("Rust and Node", rust);
  await step("Rust's wasm target", () => toolchain("target", "wasm32-unknown-unknown"));
  if (forTests) await step("rustfmt and clippy", () => toolchain("component", "rustfmt", "clippy"));
  await Promise.all([step("npm packages", installNpmPackages), meanwhile?.()]);
}
