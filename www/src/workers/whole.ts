// A worker of the whole program: what only comparisons, the synthetic experiment and the uncertainty of a rollout need. No DOM.
import * as Comlink from "comlink";
import init from "vcgpdm";
import type { WholeWorker } from "../engine/whole-protocol";
import { comparisonWorker } from "./evaluation";
import { experimentWorker } from "./experiment";
import { showLife } from "./life";
import { uncertaintyWorker } from "./uncertainty";

const worker: WholeWorker = {
  async start(wasm) {
    await Promise.all([init({ module_or_path: wasm }), showLife()]);
  },
  ...comparisonWorker,
  ...experimentWorker,
  ...uncertaintyWorker,
};

Comlink.expose(worker);
