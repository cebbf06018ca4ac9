// The motion that walks before the wasm has loaded: the first seconds of the first model's own rollout, rolled out by the package itself.
// The model, www/public/first/model.json, is kept with the sources; the motion is made from it at every build.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { at, Failure, filesUnder, whenChanged } from "./run.mjs";

const SECONDS = 4;

export function writeFirstMotion() {
  const model = at("www/public/first/model.json");
  const motion = at("www/public/first/motion.bin");
  const encoder = at("www/src/first-motion.js");
  if (!existsSync(model)) throw new Failure(`${model} is missing: the model that walks when the page opens`);
  const inputs = [model, encoder, at("scripts/first.mjs"), ...filesUnder([at("crate/pkg/node")])];
  return whenChanged("first", { inputs, outputs: [motion] }, async () => {
    const { Model } = createRequire(import.meta.url)("../crate/pkg/node/vcgpdm.js");
    const { encodeFirstMotion } = await import("../www/src/first-motion.js");
    const opened = Model.fromJson(readFileSync(model, "utf8"));
    const { frameTime, figure, joints, parts } = opened.info();
    const frames = Math.round(SECONDS / frameTime);
    const positions = opened.rollout({ frames, sequence: 0 }).positions();
    const names = joints.map((/** @type {{ name: string }} */ { name }) => name);
    writeFileSync(motion, encodeFirstMotion({ frames, frameTime, figure, joints: names, parts, positions }));
  });
}
