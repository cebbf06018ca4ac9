// What the page opens with, made from the model that is kept with the sources, www/first/model.json: the same
// model with fewer digits, and the first seconds of its rollout, which walk before the wasm has loaded; and
// the library of primitives, www/first/library.json, with fewer digits.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { at, filesUnder, whenChanged } from "./run.mjs";

/** A little more than one step of each foot: it plays again and again. */
const SECONDS = 1.5;

/**
 * Seven digits are less than half of what all sixteen are to send, and move no joint by more than a twentieth
 * of a millimetre in ten seconds.
 */
const DIGITS = 7;
/**
 * Fewer digits for the covariances of the inducing outputs. All rounding together moves the deviations of
 * predictions by less than 6 %, which tests/node/uncertainty.test.mjs holds.
 */
const COVARIANCE_DIGITS = 2;

const rounded = (/** @type {unknown} */ value, /** @type {number} */ digits) =>
  typeof value === "number" && !Number.isInteger(value) ? Number(value.toPrecision(digits)) : value;

/** Covariances get fewer digits than the rest. */
const short = (/** @type {string} */ name, /** @type {unknown} */ value) =>
  name.endsWith("_covariance") && Array.isArray(value)
    ? value.map((row) => row.map((/** @type {unknown} */ entry) => rounded(entry, COVARIANCE_DIGITS)))
    : rounded(value, DIGITS);

/**
 * The library of the view Primitives. Its covariances keep all digits that the rest keeps: couplings are
 * fitted with them.
 */
function writeLibrary() {
  const [library, sent] = [at("www/first/library.json"), at("www/public/primitives/library.json")];
  return whenChanged("library", { inputs: [library, at("scripts/first.mjs")], outputs: [sent] }, async () => {
    const fewer = (/** @type {string} */ _, /** @type {unknown} */ value) => rounded(value, DIGITS);
    mkdirSync(at("www/public/primitives"), { recursive: true });
    writeFileSync(sent, JSON.stringify(JSON.parse(readFileSync(library, "utf8")), fewer));
  });
}

export async function writeFirst() {
  await writeLibrary();
  const [model, encoder] = [at("www/first/model.json"), at("www/src/stage/first-motion.js")];
  const [sent, motion] = [at("www/public/first/model.json"), at("www/public/first/motion.bin")];
  const inputs = [model, encoder, at("scripts/first.mjs"), ...filesUnder([at("crate/wasm/pkg/node")])];
  return whenChanged("first", { inputs, outputs: [sent, motion] }, async () => {
    const { Model } = createRequire(import.meta.url)("../crate/wasm/pkg/node/vcgpdm.js");
    const { encodeFirstMotion } = await import("../www/src/stage/first-motion.js");
    const text = JSON.stringify(JSON.parse(readFileSync(model, "utf8")), short);

    const opened = Model.fromJson(text);
    const { frameTime, figure, joints, parts } = opened.info();
    const frames = Math.round(SECONDS / frameTime);
    const positions = opened.rollout({ frames, sequence: 0 }).positions();
    const names = joints.map((/** @type {{ name: string }} */ { name }) => name);
    mkdirSync(at("www/public/first"), { recursive: true });
    writeFileSync(sent, text);
    writeFileSync(motion, encodeFirstMotion({ frames, frameTime, figure, joints: names, parts, positions }));
  });
}
