// A worker of the whole program: it trains, compares, does the synthetic experiment, holds a library of
// primitives, finds the uncertainty of a rollout, knows the graphics Turing test, and models time series that
// are no body. No DOM.
import * as Comlink from "comlink";
import init from "vcgpdm";
import type { WholeWorker } from "../engine/whole-protocol";
import { comparisonWorker } from "./evaluation";
import { experimentWorker } from "./experiment";
import { libraryWorker } from "./library";
import { showLife } from "./life";
import { perceptionWorker } from "./perception";
import { seriesWorker } from "./series";
import { trainee } from "./training";
import { uncertaintyWorker } from "./uncertainty";

const worker: WholeWorker = {
  async start(wasm) {
    await Promise.all([init({ module_or_path: wasm }), showLife()]);
  },
  ...trainee,
  ...comparisonWorker,
  ...experimentWorker,
  ...libraryWorker,
  ...uncertaintyWorker,
  ...perceptionWorker,
  ...seriesWorker,
};

Comlink.expose(worker);
