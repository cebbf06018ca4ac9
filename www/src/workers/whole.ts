// A worker of the whole program: it reads clips, trains, compares, does the synthetic experiment, holds a library of
// primitives, finds the uncertainty of a rollout, knows the graphics Turing test, and models time series that
// are no body. No DOM.
import init from "vcgpdm";
import type { WholeWorker } from "../engine/whole-protocol";
import { anyModelWorker } from "./any-model";
import { clipsWorker } from "./clips";
import { comparisonWorker } from "./evaluation";
import { experimentWorker } from "./experiment";
import { libraryWorker } from "./library";
import { perceptionWorker } from "./perception";
import { seriesWorker } from "./series";
import { serve, start } from "./serve";
import { trainee } from "./training";
import { uncertaintyWorker } from "./uncertainty";

const worker: WholeWorker = {
  start: (wasm) => start(init, wasm),
  ...clipsWorker,
  ...anyModelWorker,
  ...trainee,
  ...comparisonWorker,
  ...experimentWorker,
  ...libraryWorker,
  ...uncertaintyWorker,
  ...perceptionWorker,
  ...seriesWorker,
};

serve(worker);
