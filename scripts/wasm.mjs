// The npm package `vcgpdm` in crate/wasm/pkg: the same wasm for the browser (web/) and for Node (node/), and
// a smaller one for a first visit to the page (player/), which shows clips and models and trains none.
import { copyFileSync, cpSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { wasmNotice } from "./licences.mjs";
import { completePackage, entries } from "./package.mjs";
import { at, Failure, filesUnder, isUpToDate, output, root, run, runModule, whenChanged } from "./run.mjs";

/** @typedef {{ folder: string, target: string, type: string, features: string[] }} Target */

/** @type {Target[]} */
const TARGETS = [
  { folder: "web", target: "web", type: "module", features: ["training"] },
  { folder: "node", target: "nodejs", type: "commonjs", features: ["training"] },
  { folder: "player", target: "web", type: "module", features: [] },
];

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

/** The arguments for cargo that compile the wasm with these features. */
const compile = (/** @type {string[]} */ features) => [
  ...["build", "--locked", "--release", "--package", "vcgpdm-wasm", "--target", "wasm32-unknown-unknown"],
  ...["--no-default-features", "--features", features.join(",")],
];
const BINDGEN = ["--locked", "--profile", "tools", "--package", "bindgen"];

/** What cargo makes of the package. */
const compiled = at(".tools", "wasm");

/** The first half of `buildWasm`: cargo's. It needs nothing that npm installs. */
export function compileWasm() {
  const sources = ["crate/vcgpdm", "crate/lab", "crate/wasm", "tools/bindgen", "Cargo.toml", "Cargo.lock"];
  const inputs = filesUnder(
    [...sources, ".cargo/config.toml", "scripts/wasm.mjs"].map((path) => at(path)),
    ["pkg", "target", "tests", "benches", "examples"],
  );
  const outputs = TARGETS.map(({ folder }) => at(".tools/wasm", folder, "package.json"));
  return whenChanged("wasm", { inputs, outputs, salt: output("rustc", "--version") ?? "" }, () =>
    compileTargets(compiled),
  );
}

/** The wasm with its JavaScript for each target in a folder below `place`; `more` features for all. */
async function compileTargets(/** @type {string} */ place, /** @type {string[]} */ more = []) {
  const wasm = join(metadata().target_directory, "wasm32-unknown-unknown/release/vcgpdm_wasm.wasm");
  // Neither of the two keeps all processors busy.
  const first = [...(TARGETS[0]?.features ?? []), ...more];
  await Promise.all([run("cargo", ...compile(first)), run("cargo", "build", ...BINDGEN)]);
  for (const { folder, target, type, features } of TARGETS) {
    await run("cargo", ...compile([...features, ...more]));
    await run("cargo", "run", "--quiet", ...BINDGEN, "--", wasm, join(place, folder), target);
    writeFileSync(join(place, folder, "package.json"), `${JSON.stringify({ type })}\n`);
  }
}

/** Without `small`, wasm-opt is left out: the wasm is larger, and ready sooner. */
export async function buildWasm({ small = true } = {}) {
  await compileWasm();
  const pkg = at("crate/wasm/pkg");
  const inputs = filesUnder([
    compiled,
    at("package-lock.json"),
    at("scripts/wasm.mjs"),
    at("scripts/package.mjs"),
  ]);
  const outputs = TARGETS.map(({ folder }) => join(pkg, folder, "vcgpdm.js"));
  const state = (/** @type {boolean} */ small) => ({ inputs, outputs, salt: small ? "small" : "" });
  // A small wasm from an earlier build is good for everything.
  const note = await whenChanged("package", state(small || isUpToDate("package", state(true))), async () => {
    rmSync(pkg, { recursive: true, force: true });
    cpSync(compiled, pkg, { recursive: true });
    if (small) await optimise(pkg);
    completePackage(pkg);
  });
  describe();
  return note;
}

/** The wasm of the package with `more` features, in folders below `place`. */
export async function buildVariant(/** @type {string} */ place, /** @type {string[]} */ more) {
  await compileTargets(place, more);
  await optimise(place);
}

// Who made the file and what it needs of an engine is for tools alone.
const STRIP = ["--strip-producers", "--strip-target-features"];

/**
 * Runs wasm-opt: once where the files of the targets are the same, and only the JavaScript around them
 * differs.
 */
async function optimise(/** @type {string} */ place) {
  /** @type {{ before: Buffer, file: string }[]} */
  const done = [];
  for (const { folder } of TARGETS) {
    const file = join(place, folder, "vcgpdm_bg.wasm");
    const before = readFileSync(file);
    const same = done.find((other) => other.before.equals(before));
    if (same) copyFileSync(same.file, file);
    else await runModule("binaryen/bin/wasm-opt", file, "-O3", ...STRIP, ...FEATURES, "-o", file);
    done.push({ before, file });
  }
}

/** What Cargo knows of the packages here. */
function metadata() {
  const text = output("cargo", "metadata", "--no-deps", "--format-version", "1");
  if (text === null) throw new Failure("cargo metadata failed");
  return JSON.parse(text);
}

/** Writes the package's package.json from what Cargo knows, with README and licences. */
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
    // Where the sources are, once Cargo.toml says it.
    ...(crate.repository ? { repository: { type: "git", url: `git+${crate.repository}.git` } } : {}),
    ...(crate.homepage ? { homepage: crate.homepage } : {}),
    ...entries,
    engines: { node: ">=20" },
  };
  writeFileSync(at("crate/wasm/pkg/package.json"), `${JSON.stringify(about, null, 2)}\n`);
  writeFileSync(at("crate/wasm/pkg/THIRD-PARTY.txt"), wasmNotice());
  copyFileSync(at("crate/wasm/README.md"), at("crate/wasm/pkg/README.md"));
  for (const file of readdirSync(root).filter((name) => name.startsWith("LICENSE")))
    copyFileSync(at(file), at("crate/wasm/pkg", file));
}
