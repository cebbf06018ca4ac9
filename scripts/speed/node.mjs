// One side of `npm run speed`, in a process of its own: node.mjs CASE.json [CLIP.bvh ...]
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { at } from "../run.mjs";
import { evaluation, training } from "./measure.js";

const wasm = createRequire(import.meta.url)(at("target/speed/node/vcgpdm.js"));
const [file = "", ...clips] = process.argv.slice(2);
const files = clips.map(
  (clip) => /** @type {[string, string]} */ ([basename(clip), readFileSync(clip, "utf8")]),
);
console.log(
  JSON.stringify({
    evaluation: evaluation(wasm, readFileSync(file, "utf8")),
    training: training(wasm, files),
  }),
);
