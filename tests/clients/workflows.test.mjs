// The workflows in docs/examples, run for real.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { after, describe, it } from "node:test";
import { environment } from "../../scripts/python.mjs";
import { at, env } from "../../scripts/run.mjs";

const folders = /** @type {string[]} */ ([]);
after(() => folders.forEach((folder) => rmSync(folder, { recursive: true, force: true })));

/** Runs a program in the folder, with the built `vcgpdm` on its PATH. */
function call(
  /** @type {string} */ folder,
  /** @type {NodeJS.ProcessEnv} */ more,
  /** @type {string} */ program,
  /** @type {string[]} */ ...args
) {
  const PATH = [at("target/debug"), env.PATH].join(delimiter);
  return execFileSync(program, args, {
    cwd: folder,
    env: { ...env, PATH, ...more },
    encoding: "utf8",
    stdio: "pipe",
  });
}

function freshFolder() {
  const folder = mkdtempSync(join(tmpdir(), "vcgpdm-workflow-"));
  folders.push(folder);
  return folder;
}

describe("the Snakefile", () => {
  const { bin, has } = environment("clients");
  const skip = has("snakemake") ? false : "Snakemake could not be installed";

  it("shares an evaluation out, merges and reports it, and has nothing to do the second time", {
    skip,
  }, () => {
    const folder = freshFolder();
    const options = "options=--models dmp-discrete,dmp-rhythmic --folds 1 --fps 15";
    const arguments_ = [
      "--snakefile",
      at("docs/examples/Snakefile"),
      "--cores",
      "2",
      "--config",
      "shares=3",
      options,
    ];
    call(folder, {}, join(bin, "snakemake"), ...arguments_);
    const report = readFileSync(join(folder, "evaluation/report.md"), "utf8");
    assert.match(report, /\| dmp-discrete \|/);
    const numbers = JSON.parse(readFileSync(join(folder, "evaluation/report.json"), "utf8"));
    assert.equal(numbers.subjects[0].comparison.models.length, 2);
    // Two jobs in three shares: one of them is empty, and is waited for all the same.
    const shares = readdirSync(join(folder, "evaluation")).filter((name) => /^share-\d\.json$/.test(name));
    assert.equal(shares.length, 3);
    const again = execFileSync(join(bin, "snakemake"), ["--dry-run", ...arguments_], {
      cwd: folder,
      stdio: "pipe",
    });
    assert.match(again.toString(), /Nothing to be done/);
  });
});

it("the Slurm script computes the share of its place in the array", {
  skip: process.platform === "win32",
}, () => {
  const folder = freshFolder();
  const place = { SLURM_ARRAY_TASK_ID: "7", SLURM_ARRAY_TASK_COUNT: "7", SLURM_CPUS_PER_TASK: "1" };
  const clips = ["sample:walk-1", "sample:walk-2", "--folds", "1", "--fps", "15"];
  const summary = JSON.parse(call(folder, place, "bash", at("docs/examples/evaluate.slurm"), ...clips));
  assert.deepEqual([summary.jobs, summary.computed], [1, 1]);
  assert.match(readFileSync(join(folder, "evaluation/share-7.json"), "utf8"), /"dmp-rhythmic"/);
});
