// `npm run speed -- [CASE.json] [CLIP.bvh ...] [--peer "COMMAND"]`: times of one bound with its gradient, of a
// training and of a rollout: native, wasm in Node, wasm in Chromium, and another program that prints
// {"median_ms": ...}. One thread each. `npm run speed -- --frame`: the time of one observed frame alone.
// --quick tests the command: it compiles quickly and measures once, so that its times say nothing.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { NATIVE } from "./cargo.mjs";
import { onPage } from "./chromium.mjs";
import { samples } from "./lab/subjects.mjs";
import { builtPackage } from "./package.mjs";
import { at, Failure, main, output, run, step } from "./run.mjs";
import { installTools } from "./tools.mjs";
import { buildVariant, buildWasm } from "./wasm.mjs";

const folder = at("target/speed");

/** @typedef {{ evaluation: Record<string, number>, training?: Record<string, number> }} Side */

/** The last line a command prints, as JSON. */
function json(/** @type {string} */ program, /** @type {string[]} */ ...args) {
  const text = output(program, ...args);
  if (text === null) throw new Failure(`\`${[program, ...args].join(" ")}\` failed`);
  return JSON.parse(text.split("\n").at(-1) ?? "null");
}

/** A starting point on the project's own walks, for a command without a case. */
async function ownCase(/** @type {string} */ program) {
  const file = join(folder, "case.json");
  await run(
    program,
    "train",
    ...samples("walk", 4),
    "--parts",
    "lower,upper",
    "--max-iterations",
    "1",
    "--write-start",
    file,
    "--out",
    join(folder, "model.json"),
  );
  return file;
}

/** Measures in a page of its own. */
const inChromium = (/** @type {string} */ text, /** @type {[string, string][]} */ files) =>
  onPage(folder, {}, async (page, address) => {
    await page.goto(`${address}index.html`);
    return /** @type {Side} */ (
      await page.evaluate(
        async ({ text, files, address }) => {
          const wasm = await import(`${address}web/vcgpdm.js`);
          const { evaluation, training } = await import(`${address}measure.js`);
          await wasm.default({ module_or_path: `${address}web/vcgpdm_bg.wasm` });
          return { evaluation: evaluation(wasm, text), training: training(wasm, files) };
        },
        { text, files, address },
      )
    );
  });

/** Frames of the two inferences whose times are compared. Both are longer than the search for the beginning. */
const FEW = 20;
const MANY = 60;
/** Inferences of each length; the first ones, while the engine still compiles, do not count. */
const INFERENCES = 60;
const NOT_COUNTED = 10;

/**
 * Prints the processor time of one observed frame of both parts, filter and smoother, with the npm package and the
 * model that the page opens with.
 */
function printObservedFrame() {
  const { Model } = builtPackage();
  const model = Model.fromJson(readFileSync(at("www/first/model.json"), "utf8"));
  const clip = model.rollout({ frames: 90 }).toClip();
  const milliseconds = (/** @type {number} */ frames) => {
    const before = process.cpuUsage();
    model.infer(clip, frames);
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  };
  const pairs = Array.from(
    { length: INFERENCES },
    () => (milliseconds(MANY) - milliseconds(FEW)) / (MANY - FEW),
  );
  console.log(`one observed frame of both parts: ${median(pairs.slice(NOT_COUNTED)).toFixed(2)} ms`);
}

const median = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[values.length >> 1] ?? NaN;

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { peer: { type: "string" }, frame: { type: "boolean" }, quick: { type: "boolean" } },
  });
  if (values.frame) {
    await step("npm package vcgpdm (wasm)", () => buildWasm({ small: true }));
    printObservedFrame();
    return;
  }
  await installTools();
  const [profile, place, rounds] = values.quick ? ["dev", "debug", 1] : ["release", "release", 3];
  // The tests compile the same packages; a measurement needs fewer.
  const packages = values.quick ? NATIVE : ["--package", "vcgpdm-cli", "--package", "vcgpdm-lab"];
  await run("cargo", "build", "--profile", profile, ...packages, "--bins", "--example", "speed");
  await buildVariant(folder, ["speed"], !values.quick);
  mkdirSync(folder, { recursive: true });
  copyFileSync(at("scripts/speed/measure.js"), join(folder, "measure.js"));
  writeFileSync(join(folder, "index.html"), "<!doctype html><title>speed</title>");

  const [given, ...clips] = positionals;
  const file = given ?? (await ownCase(at(`target/${place}/vcgpdm`)));
  const text = readFileSync(file, "utf8");
  const files = clips.map(
    (clip) => /** @type {[string, string]} */ ([basename(clip), readFileSync(clip, "utf8")]),
  );

  /** @type {Record<string, Side[]>} */
  const sides = {};
  const add = (/** @type {string} */ name, /** @type {Side} */ side) => {
    sides[name] = [...(sides[name] ?? []), side];
  };
  for (let round = 0; round < rounds; round++) {
    add("native", json(at(`target/${place}/examples/speed`), file, ...clips));
    add("wasm, Node", json(process.execPath, at("scripts/speed/node.mjs"), file, ...clips));
    add("wasm, Chromium", await inChromium(text, files));
    if (values.peer) {
      const [program = "", ...args] = values.peer.split(/\s+/);
      add("peer", { evaluation: json(program, ...args) });
    }
  }

  const of = (/** @type {string} */ name, /** @type {(side: Side) => number | undefined} */ value) =>
    median((sides[name] ?? []).map(value).filter((v) => v !== undefined));
  const bound = (/** @type {string} */ name) => of(name, (side) => side.evaluation.median_ms);
  const show = (/** @type {number} */ value, digits = 2) =>
    Number.isNaN(value) ? "" : value.toFixed(digits);
  console.log(`\nMedians of ${rounds} rounds, one after the other.\n`);
  console.log(
    "| | bound with gradient, ms | faster than the peer | time of native | training, s | to 99.9 % of its bound, s | rollout of 300 frames with positions, ms |",
  );
  console.log("|---|---|---|---|---|---|---|");
  for (const name of Object.keys(sides)) {
    const cells = [
      show(bound(name)),
      values.peer && name !== "peer" ? `${show(bound("peer") / bound(name), 1)} times` : "",
      show(bound(name) / bound("native")),
      ...["seconds", "seconds_to_999"].map((key) => show(of(name, (side) => side.training?.[key]))),
      show(of(name, (side) => side.training?.rollout_ms)),
    ];
    console.log(`| ${name} | ${cells.join(" | ")} |`);
  }
});
