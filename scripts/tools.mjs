// What has to be on the machine beside rustup and Node; whatever is missing is installed.
import { readFileSync } from "node:fs";
import { at, Failure, filesUnder, output, run, step, whenChanged } from "./run.mjs";

const WASM_PACK = "0.15.1";
const NODE = [20, 19];

/** The version of a crate that Cargo.lock holds. */
function locked(/** @type {string} */ crate) {
  const found = readFileSync(at("Cargo.lock"), "utf8").match(
    new RegExp(`name = "${crate}"\\r?\\nversion = "([^"]+)"`),
  );
  if (!found?.[1]) throw new Failure(`Cargo.lock does not name ${crate}`);
  return found[1];
}

/** a.b.c as numbers that can be compared from the left. */
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
  if (output("rustc", "--version") === null) await run("rustup", "default", "stable");
  const needed = oldestRust();
  const have = output("rustc", "--version") ?? "";
  if (older(numbers(have), numbers(needed)))
    throw new Failure(`Rust ${needed} or later is needed, this is ${have}: rustup update stable`);
}

/** Adds to the toolchain what it lacks. */
async function toolchain(/** @type {"target" | "component"} */ kind, /** @type {string[]} */ ...names) {
  const installed = output("rustup", kind, "list", "--installed") ?? "";
  const missing = names.filter(
    (name) => !installed.split(/\s+/).some((line) => line === name || line.startsWith(`${name}-`)),
  );
  if (missing.length > 0) await run("rustup", kind, "add", ...missing);
  return missing.length > 0 ? undefined : "there";
}

/** Building a tool takes longer than all that it does here: it need not be fast. */
const QUICKLY = ["opt-level=1", 'lto="off"', "codegen-units=16"].flatMap((how) => [
  "--config",
  `profile.release.${how}`,
]);

/** A program of exactly this version: the one on the PATH, else built into .tools/. */
async function cargoTool(
  /** @type {string} */ crate,
  /** @type {string} */ program,
  /** @type {string} */ version,
) {
  if (output(program, "--version")?.split(/\s+/).includes(version)) return "there";
  const install = (/** @type {string[]} */ ...more) =>
    run("cargo", "install", crate, "--version", `=${version}`, "--root", at(".tools"), ...QUICKLY, ...more);
  try {
    await install("--locked");
  } catch {
    // A registry mirror may lag behind the versions that the crate's own lock file names.
    console.log(`${crate}: its own lock file cannot be met here; trying without it`);
    await install();
  }
}

async function npmPackages() {
  const inputs = filesUnder(
    ["package.json", "package-lock.json", "www/package.json"].map((file) => at(file)),
  );
  return whenChanged("npm", { inputs, outputs: [at("node_modules", ".package-lock.json")] }, async () => {
    // npm is a script on Windows and a program elsewhere; npm itself says where it is when it runs us.
    const npm = process.env.npm_execpath;
    await (npm ? run(process.execPath, npm, "ci") : run("npm", "ci"));
  });
}

/** Everything the build needs; with `forTests` also what only the tests need. */
export async function installTools({ forTests = false } = {}) {
  await step("Rust and Node", rust);
  await step("Rust's wasm target", () => toolchain("target", "wasm32-unknown-unknown"));
  if (forTests) await step("rustfmt and clippy", () => toolchain("component", "rustfmt", "clippy"));
  await step(`wasm-pack ${WASM_PACK}`, () => cargoTool("wasm-pack", "wasm-pack", WASM_PACK));
  const bindgen = locked("wasm-bindgen");
  await step(`wasm-bindgen ${bindgen}`, () => cargoTool("wasm-bindgen-cli", "wasm-bindgen", bindgen));
  await step("npm packages", npmPackages);
}
