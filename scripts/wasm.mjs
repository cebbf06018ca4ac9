// The npm package `vcgpdm` in crate/wasm/pkg: the whole wasm (web/), and a smaller one for a first visit to the
// page (player/), which shows clips and models and trains none.
import { execFileSync } from "node:child_process";
import { copyFileSync, cpSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { compileLibrary } from "./cargo.mjs";
import { packageNotice } from "./licences.mjs";
import { completePackage, entries, writeNodeEntry } from "./package.mjs";
import { addresses } from "./release.mjs";
import { at, Failure, filesUnder, isUpToDate, output, root, run, runModule, whenChanged } from "./run.mjs";

const WHOLE = { folder: "web", features: ["training"] };
/** @type {{ folder: string, features: string[] }[]} */
const TARGETS = [WHOLE, { folder: "player", features: [] }];

// The features that rustc's wasm32 target and our simd128 flag turn on; wasm-opt refuses a file that uses
// others.
const FEATURES = [
  "simd",
  "bulk-memory",
  "nontrapping-float-to-int",
  "sign-ext",
  "mutable-globals",
  "reference-types",
  "multivalue",
].map((name) => `--enable-${name}`);

// Compiles on all processors, and optimises only what trains; the wasm is larger.
const QUICK = [
  'profile.release.lto="off"',
  "profile.release.codegen-units=16",
  "profile.release.package.vcgpdm-lab.opt-level=0",
  "profile.release.package.vcgpdm-wasm.opt-level=1",
].flatMap((setting) => ["--config", setting]);

/** The arguments for cargo that compile the wasm with these features. */
const compile = (/** @type {string[]} */ features, small = true) => [
  ...["build", "--locked", "--release", "--package", "vcgpdm-wasm", "--target", "wasm32-unknown-unknown"],
  ...["--config", "profile.release.opt-level=2", ...(small ? [] : QUICK)],
  ...["--no-default-features", "--features", features.join(",")],
];
/** What `cargo test` and a quick variant compile for wasm. */
export const WASM_TESTS = ["--locked", "--package", "vcgpdm-wasm", "--target", "wasm32-unknown-unknown"];
export const BINDGEN = ["--locked", "--profile", "tools", "--package", "bindgen"];

/** The folder for cargo's output. */
const compiled = at(".tools", "wasm");

/** The declarations of the types that Rust structs have. */
const declarations = at(".tools", "types.d.ts");

function rustSources() {
  const crates = ["crate/core", "crate/vcgpdm", "crate/lab", "crate/wasm", "tools/bindgen"];
  return filesUnder(
    [...crates, "Cargo.toml", "Cargo.lock", ".cargo/config.toml", "scripts/wasm.mjs"].map((path) => at(path)),
    ["pkg", "target", "tests", "benches", "js"],
  );
}

/**
 * The first half of `buildWasm`: cargo's. It needs nothing that npm installs. Without `small`, the whole wasm also
 * stands for that of a first visit, and is compiled quickly.
 */
export function compileWasm({ small = true } = {}) {
  const inputs = rustSources();
  const outputs = TARGETS.map(({ folder }) => at(".tools/wasm", folder, "package.json"));
  const state = stateOf("wasm", { inputs, outputs, salt: output("rustc", "--version") ?? "" }, small);
  return whenChanged("wasm", state, () => compileTargets({ small }));
}

/** The state of a small or a quick build. A small one from an earlier build is good for everything. */
function stateOf(
  /** @type {string} */ name,
  /** @type {import("./run.mjs").State} */ files,
  /** @type {boolean} */ small,
) {
  const state = (/** @type {boolean} */ small) => ({
    ...files,
    salt: `${files.salt}${small ? " small" : ""}`,
  });
  return state(small || isUpToDate(name, state(true)));
}

/** The wasm with its JavaScript for each target. Without `small` the first target is the only one that is compiled. */
async function compileTargets({ small = true } = {}) {
  for (const { folder, features } of TARGETS) {
    const place = join(compiled, folder);
    if (small || folder === WHOLE.folder) await compileTarget(compile(features, small), place);
    else cpSync(join(compiled, WHOLE.folder), place, { recursive: true });
  }
}

/** Compiles with these arguments for cargo, and writes the wasm with its JavaScript to `place`. */
async function compileTarget(/** @type {string[]} */ args, /** @type {string} */ place) {
  // Neither of the two keeps all processors busy, so both run at once.
  await Promise.all([run("cargo", ...args), run("cargo", "build", ...BINDGEN)]);
  const profile = args.includes("--release") ? "release" : "debug";
  const wasm = join(metadata().target_directory, `wasm32-unknown-unknown/${profile}/vcgpdm_wasm.wasm`);
  await run("cargo", "run", "--quiet", ...BINDGEN, "--", wasm, place);
  writeFileSync(join(place, "package.json"), '{"type":"module"}\n');
}

/** Prints the declarations of the Rust structs with a program for this machine. */
async function declareTypes() {
  await whenChanged("types", { inputs: rustSources(), outputs: [declarations] }, async () => {
    await compileLibrary();
    const text = output(join(metadata().target_directory, "debug/examples/types")) ?? "";
    const biome = at("node_modules/@biomejs/biome/bin/biome");
    const input = text.replace(/\/\*\*\n *\* (.*)\n *\*\//g, "/** $1 */");
    const formatted = execFileSync(biome, ["format", "--stdin-file-path=types.d.ts"], { input });
    writeFileSync(declarations, formatted);
  });
}

/** Without `small`, wasm-opt is left out: the wasm is larger, and ready sooner. */
export async function buildWasm({ small = true, types = true } = {}) {
  await Promise.all([compileWasm({ small }), types && declareTypes()]);
  const pkg = at("crate/wasm/pkg");
  const places = ["package-lock.json", "scripts/wasm.mjs", "scripts/package.mjs", "crate/wasm/js"];
  const inputs = filesUnder([
    compiled,
    ...(existsSync(declarations) ? [declarations] : []),
    ...places.map((path) => at(path)),
  ]);
  const outputs = TARGETS.map(({ folder }) => join(pkg, folder, "vcgpdm.js"));
  const state = stateOf("package", { inputs, outputs, salt: "" }, small);
  const note = await whenChanged("package", state, async () => {
    rmSync(pkg, { recursive: true, force: true });
    cpSync(compiled, pkg, { recursive: true });
    if (small) for (const { folder } of TARGETS) await optimise(join(pkg, folder));
    const types = [at("crate/wasm/js/types.d.ts"), ...(existsSync(declarations) ? [declarations] : [])];
    completePackage(pkg, types.map((file) => readFileSync(file, "utf8")).join("\n"));
  });
  describe();
  return note;
}

/**
 * The whole wasm with `more` features, in a folder below `place`. Without `small` it is compiled as for the tests in
 * wasm, which need the same.
 */
export async function buildVariant(/** @type {string} */ place, /** @type {string[]} */ more, small = true) {
  const folder = join(place, WHOLE.folder);
  const quick = ["build", ...WASM_TESTS, "--features", more.join(",")];
  await compileTarget(small ? compile([...WHOLE.features, ...more]) : quick, folder);
  if (small) await optimise(folder);
  writeNodeEntry(place);
}

// Only tools read the names of producers and the features.
const STRIP = ["--strip-producers", "--strip-target-features"];

async function optimise(/** @type {string} */ folder) {
  const file = join(folder, "vcgpdm_bg.wasm");
  // The second run still makes the file smaller; a third changes next to nothing.
  for (const _ of ["first", "second"])
    await runModule("binaryen/bin/wasm-opt", file, "-O3", ...STRIP, ...FEATURES, "-o", file);
}

/** The packages of this project, by Cargo. */
function metadata() {
  const text = output("cargo", "metadata", "--no-deps", "--format-version", "1");
  if (text === null) throw new Failure("cargo metadata failed");
  return JSON.parse(text);
}

/** Writes package.json from Cargo's metadata, with README and licences. */
function describe() {
  const crate = metadata().packages.find((/** @type {{ name: string }} */ p) => p.name === "vcgpdm");
  if (!crate) throw new Failure("cargo metadata does not name the package vcgpdm");
  const about = {
    name: crate.name,
    version: crate.version,
    description: crate.description,
    keywords: [...crate.keywords, "wasm"],
    author: "The authors of the vCGPDM playground",
    license: crate.license,
    ...addresses(crate),
    ...entries,
    engines: { node: ">=20.19" },
  };
  writeFileSync(at("crate/wasm/pkg/package.json"), `${JSON.stringify(about, null, 2)}\n`);
  writeFileSync(at("crate/wasm/pkg/THIRD-PARTY.txt"), packageNotice());
  copyFileSync(at("crate/wasm/README.md"), at("crate/wasm/pkg/README.md"));
  for (const file of readdirSync(root).filter((name) => name.startsWith("LICENSE")))
    copyFileSync(at(file), at("crate/wasm/pkg", file));
}
