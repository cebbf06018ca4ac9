// What a worker does for the synthetic experiment: makes the data, and trains on them step by step. No DOM.
import { SyntheticExperiment } from "vcgpdm";
import type { TrainingOutcome } from "../engine/protocol";
import type { Experiment, ExperimentReport, ExperimentWorker } from "../engine/whole-protocol";
import { OneTask, type Task } from "./slices";

const training = new OneTask();

async function train(
  { seed, driving }: Experiment,
  report: (report: ExperimentReport) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const start = performance.now();
  const experiment = new SyntheticExperiment(seed, driving);
  try {
    let progress = experiment.step();
    const step = () => {
      if (!progress.done) progress = experiment.step();
      return progress.done;
    };
    // Waits until the page has it: reports and the outcome travel on different ports.
    const done = await task.inSlices(step, () =>
      report({ progress, elapsed: (performance.now() - start) / 1000, findings: experiment.findings() }),
    );
    return { cancelled: !done, reason: progress.reason };
  } finally {
    experiment.free();
  }
}

export const experimentWorker: ExperimentWorker = {
  drawExperiment({ seed, driving }) {
    const drawn = new SyntheticExperiment(seed, driving);
    try {
      return drawn.truth();
    } finally {
      drawn.free();
    }
  },
  trainExperiment: (experiment, report) => training.run((task) => train(experiment, report, task)),
  cancelExperiment: () => training.cancel(),
};
