// A worker of the whole program: what only comparisons and the synthetic experiment need. No DOM.
import * as Comlink from "comlink";
import init from "vcgpdm";
import type { WholeWorker } from "../engine/whole-protocol";
import { comparisonWorker } from "./evaluation";
import { experimentWorker } from "./experiment";

const worker: WholeWorker = {
  async start(wasm) {
    await init({ module_or_path: wasm });
  },
  ...comparisonWorker,
  ...experimentWorker,
};

Comlink.expose(worker);
