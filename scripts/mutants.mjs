// `npm run mutants [-- K/N]`: changes one operator of the numerical core at a time, such as + into -, and runs
// the library's unit tests, which should fail. There are thousands of such changes, so this tries one share of
// them: share K of N, counted from 0. All changes of a share are compiled at once; the variable MUTANT selects
// one. It prints the changes that no test noticed.
import { spawnSync } from "node:child_process";
import { appendFileSync, cpSync, rmSync } from "node:fs";
import { join } from "node:path";
import { at, env, Failure, main, output, run, seconds, step } from "./run.mjs";

/** The modules of crate/vcgpdm/src that compute bounds, gradients and trainings. */
const CORE = ["gp", "models/variational", "models/search"];
const tree = at("target/mutants/tree");
const TOOL = ["run", "--quiet", "--locked", "--profile", "tools", "--package", "mutants", "--"];

const SELECT = `
pub(crate) fn mutant(number: usize) -> bool {
    static CHOSEN: std::sync::LazyLock<Option<usize>> =
        std::sync::LazyLock::new(|| std::env::var("MUTANT").ok().and_then(|text| text.parse().ok()));
    *CHOSEN == Some(number)
}
`;

/** @typedef {{ number: number, file: string, line: string, operators: string }} Mutant */

/** Copies the sources and writes the changes of the share into the copy, without the skipped ones. */
function writeMutants(/** @type {string} */ share, /** @type {Set<number>} */ skipped) {
  rmSync(tree, { recursive: true, force: true });
  for (const part of [
    "Cargo.toml",
    "Cargo.lock",
    "rust-toolchain.toml",
    ".cargo",
    "crate",
    "tools",
    "www/first",
  ])
    cpSync(at(part), join(tree, part), {
      recursive: true,
      filter: (path) => !/node_modules|\/pkg$/.test(path),
    });
  const folders = CORE.map((folder) => join(tree, "crate/vcgpdm/src", folder));
  const text = output("cargo", ...TOOL, share, [...skipped].join(), ...folders);
  if (text === null) throw new Failure("the changes could not be written");
  appendFileSync(join(tree, "crate/vcgpdm/src/lib.rs"), SELECT);
  return text.split("\n").map((row) => {
    const [number, file = "", line = "", operators = ""] = row.split("\t");
    return {
      number: Number(number),
      file: file.slice(join(tree, "crate/vcgpdm/src/").length),
      line,
      operators,
    };
  });
}

/** Messages of cargo about the library in the copy, as JSON. */
function cargo(/** @type {string[]} */ ...args) {
  // With the target folder of the project, other crates are compiled already.
  const options = ["--package", "vcgpdm", "--lib", "--message-format", "json"];
  const { stdout } = spawnSync("cargo", [...args, ...options], {
    cwd: tree,
    env: { ...env, CARGO_TARGET_DIR: env.CARGO_TARGET_DIR ?? at("target") },
    encoding: "utf8",
    maxBuffer: 1 << 28,
    stdio: ["ignore", "pipe", "ignore"],
  });
  return stdout.split("\n").flatMap((line) => (line.startsWith("{") ? [JSON.parse(line)] : []));
}

/** The numbers of the changes that do not compile: the last one before each error in the file. */
function broken() {
  const errors = cargo("check").filter(({ message }) => message?.level === "error");
  const found = errors.flatMap(({ message }) =>
    message.spans.map((/** @type {{ file_name: string, byte_start: number }} */ span) => {
      const text = output("head", "-c", String(span.byte_start + 1), join(tree, span.file_name)) ?? "";
      return Number([...text.matchAll(/crate::mutant\((\d+)usize\)/g)].at(-1)?.[1]);
    }),
  );
  if (errors.length > 0 && found.length === 0) throw new Failure("the copy does not compile");
  return found;
}

/** Whether the unit tests with these names pass with a change; false when they take too long. */
function passes(/** @type {string} */ program, /** @type {string[]} */ names, mutant = "", timeout = 0) {
  const options = { cwd: join(tree, "crate/vcgpdm"), env: { ...env, MUTANT: mutant }, timeout };
  return spawnSync(program, names, { ...options, stdio: "ignore" }).status === 0;
}

await main(async () => {
  const share = process.argv[2] ?? "0/100";
  if (!/^\d+\/\d+$/.test(share)) throw new Failure(`expected a share such as 0/100, found "${share}"`);
  await run("cargo", "build", ...TOOL.slice(1, -1));
  /** @type {Mutant[]} */
  let mutants = [];
  let program = "";
  await step("changed program", () => {
    const skipped = /** @type {Set<number>} */ (new Set());
    for (let size = -1; size < skipped.size; ) {
      size = skipped.size;
      mutants = writeMutants(share, skipped);
      for (const number of broken()) skipped.add(number);
    }
    program = cargo("test", "--no-run").find(({ executable }) => executable)?.executable ?? "";
    return `${mutants.length} changes, ${skipped.size} more do not compile`;
  });
  if (!program) throw new Failure("the changed program does not compile");
  const start = performance.now();
  if (!passes(program, [])) throw new Failure("the tests fail without a change");
  const timeout = Math.ceil(5 * (performance.now() - start)) + 10_000;
  /** @type {Mutant[]} */
  const missed = [];
  for (const mutant of mutants) {
    const { number, file, line, operators } = mutant;
    // The tests of the module first: they are quick and notice most changes.
    const module = CORE.find((folder) => file.startsWith(folder))?.replaceAll("/", "::") ?? "";
    const unnoticed = [[module], []].every((names) => passes(program, names, String(number), timeout));
    if (unnoticed) missed.push(mutant);
    console.log(`${unnoticed ? "MISSED" : "caught"}  ${number}  ${file}:${line}  ${operators}`);
  }
  console.log(`\n${mutants.length - missed.length} caught, ${missed.length} missed (${seconds(start)})`);
});
