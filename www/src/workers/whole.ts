// A worker of the whole program: what only comparisons and the synthetic lesson need. No DOM.
import * as Comlink from "comlink";
import init from "vcgpdm";
import { evaluator } from "./evaluation";
import type { Comparer } from "../engine/protocol";
import { synthesist } from "./experiment";

const comparer: Comparer = {
  async start(wasm) {
    await init({ module_or_path: wasm });
  },
  ...evaluator,
  ...synthesist,
};

Comlink.expose(comparer);
