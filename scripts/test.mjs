// `npm test`: everything, in order, then a table. `npm test -- --only NAME` runs one step.
import { at, env, Failure, filesUnder, main, run, runModule, seconds } from "./run.mjs";
import { build } from "./build.mjs";
import { weigh } from "./site.mjs";
import { installTools } from "./tools.mjs";

const deny = ["--", "-D", "warnings"];
const nodeTests = (/** @type {string} */ folder) =>
  run(
    process.execPath,
    "--test",
    "--test-reporter=spec",
    "--test-concurrency=1",
    "--test-timeout=600000",
    ...filesUnder([at("tests", folder)]).filter((file) => file.endsWith(".test.mjs")),
  );

/** @type {{ name: string, what: string, needs?: string, work: () => Promise<void> }[]} */
const STEPS = [
  { name: "format", what: "rustfmt", work: () => run("cargo", "fmt", "--all", "--check") },
  {
    name: "clippy",
    what: "clippy, native",
    work: () => run("cargo", "clippy", "--all-targets", "--all-features", ...deny),
  },
  {
    name: "clippy-wasm",
    what: "clippy, wasm32",
    work: () =>
      run("cargo", "clippy", "--lib", "--target", "wasm32-unknown-unknown", "--features", "comparison,speed", ...deny),
  },
  { name: "rust", what: "Rust tests and doctests", work: () => run("cargo", "test", "--all-features") },
  {
    name: "rust-wasm",
    what: "Rust tests in wasm, in Node",
    work: () => run("wasm-pack", "test", "--node", "--mode", "no-install", at("crate")),
  },
  { name: "build", what: "wasm package and page", work: build },
  { name: "sizes", what: "the budget of a visit", needs: "build", work: async () => weigh() },
  { name: "node", what: "the npm package from Node", needs: "build", work: () => nodeTests("node") },
  { name: "types", what: "TypeScript, strict", work: types },
  { name: "unit", what: "Vitest", work: () => runModule("vitest/vitest.mjs", "run", "--root", at("www")) },
  { name: "page", what: "the page in Chromium", needs: "build", work: () => nodeTests("e2e") },
];

async function types() {
  for (const project of ["www", "tests"]) await runModule("typescript/bin/tsc", "--noEmit", "-p", at(project));
}

function chosen() {
  const i = process.argv.indexOf("--only");
  if (i < 0) return STEPS;
  const name = process.argv[i + 1];
  const step = STEPS.find((step) => step.name === name);
  if (!step)
    throw new Failure(
      `--only is to name one of ${STEPS.map((step) => step.name).join(", ")}; found ${name ?? "nothing"}`,
    );
  const before = STEPS.filter(({ name }) => name === step.needs);
  return [...before, step];
}

await main(async () => {
  const steps = chosen();
  await installTools({ forTests: true });
  env.CARGO_TERM_COLOR ??= process.stdout.isTTY ? "always" : "never";

  /** @type {{ name: string, what: string, time: string, failure: string | null }[]} */
  const results = [];
  for (const { name, what, needs, work } of steps) {
    const start = performance.now();
    console.log(`\n==== ${name}: ${what}`);
    let failure = null;
    try {
      const broken = results.some((result) => result.name === needs && result.failure !== null);
      if (broken) throw new Failure(`not run: ${needs} failed`);
      await work();
    } catch (error) {
      failure = error instanceof Failure ? error.message : String(error instanceof Error ? error.stack : error);
      console.error(`error: ${failure}`);
    }
    results.push({ name, what, time: seconds(start), failure });
  }

  console.log("\n");
  for (const { name, what, time, failure } of results) {
    console.log(
      `${failure === null ? "passed" : "FAILED"}  ${name.padEnd(12)} ${what.padEnd(28)} ${time.padStart(12)}${failure ? `   ${failure.split("\n")[0]}` : ""}`,
    );
  }
  const failed = results.filter(({ failure }) => failure !== null).length;
  console.log(`\n${results.length - failed} passed, ${failed} failed`);
  if (failed > 0) process.exitCode = 1;
});
