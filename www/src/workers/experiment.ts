// The synthetic experiment: makes the data, and trains on them step by step. No DOM.
import { SyntheticExperiment } from "vcgpdm";
import type { ExperimentWorker } from "../engine/whole-protocol";
import { follow } from "./follow";
import { using } from "./using";

export const experimentWorker: ExperimentWorker = {
  drawExperiment: ({ seed, driving }) =>
    using(new SyntheticExperiment(seed, driving), (experiment) => experiment.truth()),
  trainExperiment: ({ seed, driving }, report, signal) =>
    using(new SyntheticExperiment(seed, driving), (experiment) =>
      follow({ step: () => experiment.step(), find: () => experiment.findings() }, report, signal),
    ),
};
