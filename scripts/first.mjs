// Makes the files that the page opens with: from those in www/first the model and the library of primitives
// with fewer digits, and the first seconds of the model's rollout, which play before the wasm has loaded.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { rounded, shortened } from "../www/src/links/digits.js";
import { builtPackage } from "./package.mjs";
import { at, filesUnder, whenChanged } from "./run.mjs";

/** A little more than one step of each foot; it plays in a loop. */
const SECONDS = 1.5;

/**
 * Digits of matrices; other numbers have seven. All rounding together changes the deviations of predictions
 * by less than 6 % (tests/node/uncertainty.test.mjs), and the bound of a model with fewer inducing points by
 * less than 2 nats.
 */
const MATRIX_DIGITS = { u_covariance: 2, sum_psi2: 9 };
const digits = at("www/src/links/digits.js");

/**
 * The library of the view Primitives. Its covariances keep seven digits, because couplings are fitted with
 * them.
 */
function writeLibrary() {
  const [library, sent] = [at("www/first/library.json"), at("www/public/primitives/library.json")];
  const inputs = [library, digits, at("scripts/first.mjs")];
  return whenChanged("library", { inputs, outputs: [sent] }, async () => {
    const fewer = (/** @type {string} */ _, /** @type {unknown} */ value) => rounded(value);
    mkdirSync(at("www/public/primitives"), { recursive: true });
    writeFileSync(sent, JSON.stringify(JSON.parse(readFileSync(library, "utf8")), fewer));
  });
}

export async function writeFirst() {
  await writeLibrary();
  const [model, encoder] = [at("www/first/model.json"), at("www/src/stage/first-motion.js")];
  const [sent, motion] = [at("www/public/first/model.json"), at("www/public/first/motion.bin")];
  const own = [encoder, digits, at("scripts/first.mjs")];
  const inputs = [model, ...own, ...filesUnder([at("crate/wasm/pkg/node")])];
  return whenChanged("first", { inputs, outputs: [sent, motion] }, async () => {
    const { Model } = builtPackage();
    const { encodeFirstMotion } = await import("../www/src/stage/first-motion.js");
    const text = JSON.stringify(shortened(JSON.parse(readFileSync(model, "utf8")), MATRIX_DIGITS));

    const opened = Model.fromJson(text);
    const info = /** @type {import("vcgpdm").CoupledModelInfo} */ (opened.info());
    const { frameTime, figure, joints, parts } = info;
    const frames = Math.round(SECONDS / frameTime);
    const positions = opened.rollout({ frames, sequence: 0 }).positions();
    const names = joints.map(({ name }) => name);
    mkdirSync(at("www/public/first"), { recursive: true });
    writeFileSync(sent, text);
    writeFileSync(motion, encodeFirstMotion({ frames, frameTime, figure, joints: names, parts, positions }));
  });
}
