// Makes the files that the page opens with: from those in www/first the model and the library of primitives
// with fewer digits, and the first seconds of the model's rollout, which play before the wasm has loaded; from
// the study some walkers for the first chapter of the story.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { rounded, shortened } from "../www/src/links/digits.js";
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

/** Walkers of the study, in pairs: the program's walk, and a model's prediction of it. */
const WALKERS = [
  ["trial-1", "vcgpdm-3-12-trial-1"],
  ["trial-2", "vcgpdm-3-4-trial-2"],
  ["trial-2", "vcgpdm-12-12-trial-2"],
].flat();

/** The lights of these walkers: without the other nodes and stimuli, the file is a tenth of the study. */
function writeWalkers() {
  const [study, encoder] = [at("www/public/study/walks.study.json"), at("www/src/stage/first-motion.js")];
  const sent = at("www/public/first/walkers.bin");
  const inputs = [study, encoder, at("scripts/first.mjs"), ...filesUnder([at("crate/wasm/pkg/node")])];
  return whenChanged("walkers", { inputs, outputs: [sent] }, async () => {
    const { Study } = createRequire(import.meta.url)("../crate/wasm/pkg/node/vcgpdm.js");
    const { encodeFirstMotion } = await import("../www/src/stage/first-motion.js");
    const opened = Study.fromJson(readFileSync(study, "utf8"));
    const { skeleton, framesPerSecond, stimuli } = opened.info;
    const { dots, names, parents } = skeleton;
    const walkers = WALKERS.map((id) => {
      const place = stimuli.findIndex((/** @type {{ id: string }} */ stimulus) => stimulus.id === id);
      const all = opened.positions(place);
      const frames = all.length / 3 / parents.length;
      const positions = Array.from({ length: frames }, (_, frame) =>
        dots.flatMap((/** @type {number} */ node) => {
          const first = 3 * (frame * parents.length + node);
          return [...all.subarray(first, first + 3)];
        }),
      ).flat();
      return { name: id, frames, speed: stimuli[place].speed, positions };
    });
    const motion = {
      frames: walkers.reduce((sum, { frames }) => sum + frames, 0),
      frameTime: 1 / framesPerSecond,
      figure: { nodes: dots.map(() => ({ joint: 0, parent: null, endSite: false })) },
      joints: dots.map((/** @type {number} */ node) => names[node]),
      parts: [],
      positions: Float32Array.from(walkers.flatMap(({ positions }) => positions)),
      ranges: walkers.map(({ name, frames, speed }) => ({ name, frames, speed })),
    };
    mkdirSync(at("www/public/first"), { recursive: true });
    writeFileSync(sent, encodeFirstMotion(motion));
  });
}

export async function writeFirst() {
  await writeLibrary();
  await writeWalkers();
  const [model, encoder] = [at("www/first/model.json"), at("www/src/stage/first-motion.js")];
  const [sent, motion] = [at("www/public/first/model.json"), at("www/public/first/motion.bin")];
  const own = [encoder, digits, at("scripts/first.mjs")];
  const inputs = [model, ...own, ...filesUnder([at("crate/wasm/pkg/node")])];
  return whenChanged("first", { inputs, outputs: [sent, motion] }, async () => {
    const { Model } = createRequire(import.meta.url)("../crate/wasm/pkg/node/vcgpdm.js");
    const { encodeFirstMotion } = await import("../www/src/stage/first-motion.js");
    const text = JSON.stringify(shortened(JSON.parse(readFileSync(model, "utf8")), MATRIX_DIGITS));

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
