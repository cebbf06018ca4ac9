// `npm run fuzz -- bvh|model|results|study|answers [MINUTES]`: feeds a reader of the library with broken
// files. libFuzzer makes them, guided by the branches that the reader takes; it needs a nightly Rust. Files
// that break the reader go to fuzz/artifacts.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { builtPackage } from "./package.mjs";
import { at, env, Failure, main, output, run } from "./run.mjs";
import { buildWasm } from "./wasm.mjs";

const TARGETS = ["bvh", "model", "results", "study", "answers"];
const DICTIONARIES = ["bvh", "json"];
// As `cargo fuzz` does: the compiler counts every branch and reports the operands of comparisons.
const COVERAGE = [
  "--cfg fuzzing",
  "-Cpasses=sancov-module",
  ...["level=4", "inline-8bit-counters", "pc-table", "trace-compares"].map(
    (what) => `-Cllvm-args=-sanitizer-coverage-${what}`,
  ),
].join(" ");

/**
 * Small inputs to begin with: a made clip, a model, empty results, a study of one moving node, the answers of
 * a participant.
 */
function seeds(/** @type {string} */ target) {
  if (target === "answers")
    return ["p1.csv", "p2.csv"].map((file) => readFileSync(at("tests/perception", file), "utf8"));
  if (target === "study") return [smallStudy()];
  const { Clip, Results, Trainer, TrainingSet } = builtPackage();
  const set = new TrainingSet();
  const [clip, other] = [Clip.sample("walk-1").cut(0, 20), Clip.sample("walk-2").cut(0, 20)];
  for (const one of [clip, other]) set.add(one);
  if (target === "bvh") return [clip.cut(0, 3).toBvh()];
  const { parts = [] } = clip.info().presets.find(({ id }) => id === "lower-upper") ?? {};
  const common = { parts, framesPerSecond: 10 };
  if (target === "results") return [Results.empty(set, common).toJson()];
  const few = { latent: 1, order: 1, dynamicsIps: 2, poseIps: 2, maxIterations: 2, seed: 1 };
  return [new Trainer(set, { ...common, ...few }).model().toJson()];
}

/** The page's study, reduced to a node and three movements. */
function smallStudy() {
  const study = JSON.parse(readFileSync(at("www/public/study/walks.study.json"), "utf8"));
  const still = (/** @type {{ kind: string }} */ stimulus) => ({
    ...stimulus,
    frames: 6,
    places: "A".repeat(18),
  });
  study.seconds = 0.2;
  study.figure = { ...study.figure, names: ["Hips"], parents: [null], joints: 1, dots: [0] };
  for (const name of ["head", "feet"]) delete study.figure[name];
  study.stimuli = [0, 4, 6].map((k) => still(study.stimuli[k]));
  return JSON.stringify(study);
}

await main(async () => {
  const [target = "", minutes = "5"] = process.argv.slice(2);
  if (!TARGETS.includes(target))
    throw new Failure(`expected one of ${TARGETS.join(", ")}, found "${target}"`);
  if (!(Number(minutes) > 0)) throw new Failure(`expected minutes above 0, found "${minutes}"`);
  const host = /host: (\S+)/.exec(output("rustc", "+nightly", "-vV") ?? "")?.[1];
  if (!host) throw new Failure("a nightly Rust is needed: rustup toolchain install nightly");
  await buildWasm();
  const corpus = at("fuzz/corpus", target);
  mkdirSync(corpus, { recursive: true });
  mkdirSync(at("fuzz/artifacts"), { recursive: true });
  for (const [k, seed] of seeds(target).entries()) writeFileSync(`${corpus}/seed-${k}`, seed);
  env.RUSTFLAGS = COVERAGE;
  const place = ["--manifest-path", at("fuzz/Cargo.toml"), "--target", host];
  await run("cargo", "+nightly", "build", "--release", ...place, "--bin", target);
  const dictionary = at("fuzz", `${target === "bvh" ? DICTIONARIES[0] : DICTIONARIES[1]}.dict`);
  const limits = [
    "-timeout=10",
    "-rss_limit_mb=2048",
    "-max_len=200000",
    `-max_total_time=${60 * Number(minutes)}`,
  ];
  const found = `-artifact_prefix=${at("fuzz/artifacts")}/${target}-`;
  await run(at("fuzz/target", host, "release", target), corpus, `-dict=${dictionary}`, found, ...limits);
});
