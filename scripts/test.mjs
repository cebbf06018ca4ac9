// `npm test`: the tests, in two lanes, then a table. `npm test -- --all` adds the steps, and the tests of the page,
// that a change seldom breaks; `npm test -- --only NAME,NAME` runs these steps, each with all of its tests.
import { fork } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { setPriority } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { at, env, Failure, main, output, run, runModule, seconds } from "./run.mjs";
import { build } from "./build.mjs";
import { findChromium, inOneChromium } from "./chromium.mjs";
import { compileLibrary, compileTests, NATIVE, TESTS } from "./cargo.mjs";
import { checkGolden } from "./golden.mjs";
import { checkLines } from "./lines.mjs";
import { checkLocks } from "./locks.mjs";
import { nodeTests, often } from "./node-tests.mjs";
import { checkRustImports } from "./rust-imports.mjs";
import { weigh } from "./site.mjs";
import { installNpmPackages, installTools, oldestRust } from "./tools.mjs";
import { WASM_TESTS } from "./wasm.mjs";

/** In rustdoc's list of all items of the library. */
const MOST_PUBLIC_ITEMS = 120;
const deny = ["--", "-D", "warnings"];
/** Golden cases in the wasm package: only `npm run speed` compiles them. */
const SPEED = ["--features", "vcgpdm-wasm/speed"];

const clippy = (/** @type {string[]} */ ...what) => run("cargo", "clippy", ...what, ...deny);
const biome = (/** @type {string[]} */ ...args) => runModule("@biomejs/biome/bin/biome", ...args);

/** The Rust tests that are marked `seldom`, too. Those on recordings have a step of their own. */
const WITH_SELDOM = ["--", "--include-ignored", "--skip", "recordings::", "--skip", "acclaim::"];

/** The argument of a process that runs one step for another process. */
const THIS_STEP = "--this-step";

/**
 * A step may return a note. A note that begins with "skipped: " says why this machine cannot do the step.
 * `seldom`: a step of `--all`. `compiles`: it compiles Rust, and nothing in it waits for a browser.
 * @typedef {{
 *   name: string, what: string, needs?: string, seldom?: true, compiles?: boolean, work: () => Promise<string | void>
 * }} Step
 */

/** @type {Step[]} */
const PAGE_STEPS = [
  { name: "format", what: "rustfmt and Biome", work: format },
  { name: "lint", what: "Biome", work: () => biome("lint", "--error-on-warnings") },
  { name: "locks", what: "hashes in the lock files", work: checkLocks },
  { name: "lines", what: "size of the project", work: async () => checkLines() },
  { name: "imports", what: "order and circles of imports", work: imports },
  { name: "build", what: "wasm package and page", compiles: true, work: () => build({ small: !often() }) },
  { name: "sizes", what: "sizes of a visit", needs: "build", work: async () => weigh({ small: !often() }) },
  { name: "node", what: "the npm package from Node", needs: "build", work: () => nodeTests("node") },
  { name: "types", what: "TypeScript, strict", needs: "build", work: types },
  {
    name: "unit",
    what: "Vitest",
    needs: "build",
    work: () => runModule("vitest/vitest.mjs", "run", "--root", at("www")),
  },
  { name: "page", what: "the page in Chromium", needs: "build", work: page },
  { name: "times", what: "commands that measure time", seldom: true, needs: "build", work: times },
];

/** @type {Step[]} */
const RUST_STEPS = [
  // First: cargo lets the build of the page wait for what the other steps compile.
  { name: "library", what: "the library, compiled", work: compileLibrary },
  // These share what they compile: clippy, the features and the documentation need no more than metadata.
  { name: "clippy", what: "clippy", seldom: true, work: () => clippy(...NATIVE, ...SPEED, "--all-targets") },
  { name: "features", what: "each feature alone", seldom: true, work: features },
  { name: "docs", what: "the documentation", seldom: true, work: docs },
  { name: "msrv", what: `Rust ${oldestRust()}, the oldest`, seldom: true, work: msrv },
  {
    name: "rust",
    what: "Rust tests and doctests",
    work: async () => {
      await run("cargo", "test", ...NATIVE, ...TESTS, ...(often() ? [] : WITH_SELDOM));
      await run("cargo", "test", ...NATIVE, "--doc");
    },
  },
  { name: "measurements", what: "measurements in short", seldom: true, work: measurements },
  { name: "recordings", what: "Rust tests on recordings", work: recordings },
  { name: "files", what: "model files read with numpy", work: files },
  { name: "golden", what: "golden numbers, computed again", work: checkGolden },
  { name: "rust-wasm", what: "Rust tests in wasm, in Node", seldom: true, work: rustInWasm },
];

/**
 * Both lanes run at once, each one step after the other: browsers wait much, and a linker uses one core. What
 * compiles Rust has the lower priority, so that a test in a browser does not wait for the compiler.
 */
const LANES = [PAGE_STEPS, RUST_STEPS.map((step) => ({ ...step, compiles: true }))];
/** The lower priority, as for `nice`. */
const PATIENT = 10;
const STEPS = LANES.flat();

/** Which files may use each other: the rules are in tools/page-imports and tools/rust-imports. */
async function imports() {
  await installNpmPackages("tools/page-imports");
  const cruiser = "tools/page-imports/node_modules/dependency-cruiser/bin/dependency-cruise.mjs";
  await run(process.execPath, at(cruiser), "--config", at("tools/page-imports/order.cjs"), "www/src");
  checkRustImports();
  await nodeTests("imports");
}

async function format() {
  await run("cargo", "fmt", "--all", "--check");
  await run("cargo", "fmt", "--manifest-path", at("crate/python/Cargo.toml"), "--check");
  await biome("format");
}

/** Each feature must compile without the others; the build compiles the wasm without any. */
async function features() {
  await clippy("--package", "vcgpdm");
  await clippy("--package", "vcgpdm-wasm", "--no-default-features", ...SPEED);
}

/**
 * All documentation, with the examples because clippy has compiled the crates with them already. Then the
 * public library alone: its items are few, and no two public items have the same name.
 */
async function docs() {
  const doc = (/** @type {string[]} */ ...what) =>
    run("cargo", "doc", "--no-deps", "--config", 'build.rustdocflags = ["-D", "warnings"]', ...what);
  await doc(...NATIVE, "--lib", "--examples");
  await doc("--package", "vcgpdm", "--lib");
  const items = ["vcgpdm", "vcgpdm_lab"].map(documentedItems);
  const [library = []] = items;
  if (library.length > MOST_PUBLIC_ITEMS)
    throw new Failure(`vcgpdm: expected at most ${MOST_PUBLIC_ITEMS} public items, found ${library.length}`);
  const names = items.flat().map((path) => path.split("::").at(-1));
  const twice = names.filter((name, i) => names.indexOf(name) < i);
  if (twice.length > 0) throw new Failure(`public names that stand for two items: ${twice.join(", ")}`);
  return `vcgpdm has ${library.length} public items`;
}

/** The paths in rustdoc's list of all items. */
function documentedItems(/** @type {string} */ crate) {
  const target = env.CARGO_TARGET_DIR ?? at("target");
  const list = readFileSync(join(target, "doc", crate, "all.html"), "utf8");
  return [...list.matchAll(/<li><a href="[^"]+">([^<]+)<\/a>/g)].map(([, path = ""]) => path);
}

/** Only the library and the program promise the oldest Rust; tests and examples may need a newer one. */
async function msrv() {
  const version = oldestRust();
  const toolchains = (output("rustup", "toolchain", "list") ?? "").split("\n");
  if (!toolchains.some((line) => line.startsWith(`${version}-`))) {
    try {
      await run("rustup", "toolchain", "install", version, "--profile", "minimal", "--no-self-update");
    } catch {
      return `skipped: Rust ${version} is not here and could not be installed`;
    }
  }
  await run("cargo", `+${version}`, "check", "--package", "vcgpdm", "--package", "vcgpdm-cli");
}

/** The measurements behind the documents, each as short as it can be. What they need was compiled for the tests. */
async function measurements() {
  await run("cargo", "build", "--profile", "test", ...NATIVE, "--example", "lab");
  const program = join(env.CARGO_TARGET_DIR ?? at("target"), "debug/examples/lab");
  await run(program, "scaling", "--size", "60", "2", "6", "2");
  await run(program, "seeds", "--seeds", "1", "--iterations", "2", "--parts", "whole", "--points", "6");
  await run(program, "synthetic", "--seeds", "1", "--max-iterations", "2");
  await run(process.execPath, at("scripts/lab.mjs"), "comparison", "--quick", "walk-made");
}

/** The tests that need recordings, which are not part of the project. */
async function recordings() {
  env.VCGPDM_CLIPS ??= at("../shared/bvh");
  if (!existsSync(env.VCGPDM_CLIPS)) return `skipped: no recordings in ${env.VCGPDM_CLIPS}: set VCGPDM_CLIPS`;
  const names = ["recordings::", ...(env.VCGPDM_ACCLAIM ? ["acclaim::"] : [])];
  const tests = ["test", ...NATIVE, ...TESTS, "--", "--ignored", ...names];
  await run("cargo", ...tests);
  const count = (output("cargo", ...tests, "--list") ?? "").match(/: test$/gm)?.length ?? 0;
  if (count === 0) throw new Failure("expected tests in modules named recordings, found none");
  return `${count} tests${env.VCGPDM_ACCLAIM ? "" : "; none on asf and amc: set VCGPDM_ACCLAIM"}`;
}

async function rustInWasm() {
  env.CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER = `node ${at("scripts/wasm-tests.mjs")}`;
  await run("cargo", "test", ...WASM_TESTS, "--lib", "--tests");
}

async function page() {
  // Each file would say the same after it has served the page.
  if (findChromium() === null) return "skipped: no Chromium";
  return inOneChromium(() => nodeTests("e2e", 2, true));
}

/** In short: what they print is no measurement. */
async function times() {
  if (findChromium() === null) return "skipped: no Chromium";
  await run(process.execPath, at("scripts/alpha.mjs"), "--events", "5");
  await run(process.execPath, at("scripts/speed.mjs"), "--quick");
}

async function files() {
  // The step of the Rust tests has compiled the program already.
  await compileTests();
  await nodeTests("files");
}

async function types() {
  for (const project of ["www", "tests"])
    await runModule("typescript/bin/tsc", "--noEmit", "-p", at(project));
}

function chosen() {
  const i = process.argv.indexOf("--only");
  if (i < 0) return STEPS.filter(({ seldom }) => !seldom || process.argv.includes("--all"));
  const names = (process.argv[i + 1] ?? "nothing").split(",");
  const all = STEPS.map(({ name }) => name);
  const unknown = names.find((name) => !all.includes(name));
  if (unknown !== undefined)
    throw new Failure(`--only needs names of ${all.join(", ")}, with commas; found ${unknown}`);
  const needed = STEPS.filter(({ name }) => names.includes(name)).map(({ needs }) => needs);
  return STEPS.filter(({ name }) => names.includes(name) || needed.includes(name));
}

/** @typedef {{ outcome: "passed" | "skipped" | "FAILED", note: string }} Result */

/** @returns {Promise<Result>} */
async function resultOf(/** @type {Step} */ { work }) {
  try {
    const note = (await work()) ?? "";
    return { outcome: note.startsWith("skipped: ") ? "skipped" : "passed", note };
  } catch (error) {
    if (error instanceof Failure) return { outcome: "FAILED", note: error.message };
    return { outcome: "FAILED", note: String(error instanceof Error ? error.stack : error) };
  }
}

/**
 * Runs a step in a process of its own, and prints the output at its end: outputs of two steps do not mix.
 * @returns {Promise<Result>}
 */
function apart(/** @type {string} */ name, /** @type {number} */ priority) {
  const child = fork(fileURLToPath(import.meta.url), [THIS_STEP, name], { silent: true, env });
  if (child.pid !== undefined) setPriority(child.pid, priority);
  /** @type {Buffer[]} */
  const printed = [];
  for (const stream of [child.stdout, child.stderr]) stream?.on("data", (data) => printed.push(data));
  return new Promise((resolve) => {
    /** @type {Result} */
    let result = { outcome: "FAILED", note: "the process of the step died" };
    child.once("message", (message) => {
      result = /** @type {Result} */ (message);
    });
    child.once("close", () => {
      process.stdout.write(Buffer.concat(printed));
      resolve(result);
    });
  });
}

/** Runs steps of a lane one after the other and adds their results. */
async function runLane(
  /** @type {Step[]} */ steps,
  /** @type {Map<string, Result & { time: string }>} */ results,
  /** @type {(step: Step) => Promise<Result>} */ work,
) {
  for (const step of steps) {
    const { name, what, needs = "" } = step;
    const start = performance.now();
    console.log(`\n==== ${name}: ${what}`);
    /** @type {Result} */
    const broken = { outcome: "FAILED", note: `not run: ${needs} failed` };
    const result = results.get(needs)?.outcome === "FAILED" ? broken : await work(step);
    const note = result.outcome === "FAILED" ? `error: ${result.note}` : result.note;
    if (note) console.log(`${name}: ${note}`);
    results.set(name, { ...result, time: seconds(start) });
  }
}

/** Runs all steps, or those of `--only`, and prints a table. */
async function runAll() {
  const steps = chosen();
  await installTools({ forTests: true });
  // tests/e2e/site.mjs says which tests these are.
  if (!process.argv.includes("--all") && !process.argv.includes("--only")) env.PAGE_TESTS = "often";
  env.CARGO_TERM_COLOR ??= process.stdout.isTTY ? "always" : "never";
  const begin = performance.now();

  /** @type {Map<string, Result & { time: string }>} */
  const results = new Map();
  if (process.argv.includes("--only")) await runLane(steps, results, resultOf);
  else
    await Promise.all(
      LANES.map((lane) =>
        runLane(
          lane.filter((step) => steps.includes(step)),
          results,
          ({ name, compiles }) => apart(name, compiles ? PATIENT : 0),
        ),
      ),
    );

  console.log("\n");
  for (const { name, what } of steps) {
    const { outcome, note, time } = results.get(name) ?? { outcome: "FAILED", note: "", time: "" };
    const row = [outcome, "", name.padEnd(12), what.padEnd(28), time.padStart(12), "", note.split("\n")[0]];
    console.log(row.join(" ").trimEnd());
  }
  const count = (/** @type {string} */ wanted) =>
    [...results.values()].filter(({ outcome }) => outcome === wanted).length;
  const counts = `${count("passed")} passed, ${count("FAILED")} failed, ${count("skipped")} skipped`;
  console.log(`\n${counts} in ${seconds(begin)}`);
  if (count("FAILED") > 0) process.exitCode = 1;
}

const [, , option, name] = process.argv;
const step = STEPS.find((step) => option === THIS_STEP && step.name === name);
if (step) process.send?.(await resultOf(step), () => process.disconnect());
else await main(runAll);
