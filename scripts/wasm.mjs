// The npm package `vcgpdm` in crate/wasm/pkg: the same wasm for the browser (web/) and for Node (node/), and
// a smaller one for a first visit to the page (player/), which shows clips and models and trains none.
import { copyFileSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { noticeOfWasm } from "./licences.mjs";
import { completePackage, entries } from "./package.mjs";
import { at, Failure, filesUnder, output, root, run, runModule, whenChanged } from "./run.mjs";

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

export async function buildWasm() {
  const sources = [
    "crate/vcgpdm",
    "crate/lab",
    "crate/wasm",
    "Cargo.toml",
    "Cargo.lock",
    ".cargo/config.toml",
    "package-lock.json",
    "scripts/wasm.mjs",
    "scripts/package.mjs",
  ];
  const inputs = filesUnder(
    sources.map((path) => at(path)),
    ["pkg", "target", "tests", "benches", "examples"],
  );
  const outputs = TARGETS.map(({ folder }) => at("crate/wasm/pkg", folder, "vcgpdm.js"));
  const note = await whenChanged(
    "wasm",
    { inputs, outputs, salt: output("rustc", "--version") ?? "" },
    async () => {
      rmSync(at("crate/wasm/pkg"), { recursive: true, force: true });
      await buildPackage(at("crate/wasm/pkg"));
      completePackage(at("crate/wasm/pkg"));
    },
  );
  describe();
  return note;
}

/** The wasm with its JavaScript for each target in a folder below `place`; `more` features for all. */
export async function buildPackage(/** @type {string} */ place, /** @type {string[]} */ more = []) {
  for (const { folder, target, type, features } of TARGETS) {
    // The tools are there already, and wasm-opt is ours: wasm-pack must not fetch its own.
    const build = ["--mode", "no-install", "--target", target, "--out-name", "vcgpdm", "--no-pack"];
    const out = ["--out-dir", join(place, folder)];
    await run(
      "wasm-pack",
      "build",
      at("crate/wasm"),
      ...build,
      ...out,
      "--",
      "--no-default-features",
      "--features",
      [...features, ...more].join(","),
    );
    rmSync(join(place, folder, ".gitignore"), { force: true }); // npm would leave out what it names
    writeFileSync(join(place, folder, "package.json"), `${JSON.stringify({ type })}\n`);
  }
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

/** Writes the package's package.json from what Cargo knows, with README and licences. */
function describe() {
  const metadata = JSON.parse(output("cargo", "metadata", "--no-deps", "--format-version", "1") ?? "null");
  const crate = metadata?.packages.find((/** @type {{ name: string }} */ p) => p.name === "vcgpdm");
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
  writeFileSync(at("crate/wasm/pkg/THIRD-PARTY.txt"), noticeOfWasm());
  copyFileSync(at("crate/wasm/README.md"), at("crate/wasm/pkg/README.md"));
  for (const file of readdirSync(root).filter((name) => name.startsWith("LICENSE")))
    copyFileSync(at(file), at("crate/wasm/pkg", file));
}
