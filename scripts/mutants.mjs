// `npm run mutants [-- K/N]`: changes the numerical core in one place at a time and runs the library's tests,
// which should fail. There are thousands of such changes, so this tries one share of them: share K of N,
// counted from 0. The report is in .tools/mutants/mutants.out; its file missed.txt lists the changes that no
// test noticed.
import { mkdirSync } from "node:fs";
import { at, env, Failure, main, run, step } from "./run.mjs";
import { installCargoTool } from "./tools.mjs";

/** The modules of crate/vcgpdm/src that compute bounds, gradients and trainings. */
const CORE = ["gp", "models/variational", "models/search"];

await main(async () => {
  const share = process.argv[2] ?? "0/100";
  if (!/^\d+\/\d+$/.test(share)) throw new Failure(`expected a share such as 0/100, found "${share}"`);
  await step("cargo-mutants", () => installCargoTool("cargo-mutants", "27.1.0"));
  const output = at(".tools", "mutants");
  mkdirSync(output, { recursive: true });
  const files = CORE.flatMap((folder) => ["--file", `crate/vcgpdm/src/${folder}/**/*.rs`]);
  // A change can make a loop endless: five minutes are many times what the tests take.
  const options = ["--package", "vcgpdm", "--timeout", "300", "--sharding", "round-robin", "--shard", share];
  env.CARGO_TERM_COLOR ??= "never";
  await run("cargo", "mutants", ...options, ...files, "--output", output, "--", "--lib", "--tests");
});
