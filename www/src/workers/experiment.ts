// What a worker does for the synthetic lesson: makes the data, and trains on them step by step. No DOM.
import { SyntheticExperiment } from "vcgpdm";
import type {
  ExperimentJob,
  Experimenter,
  ExperimentReport,
  TrainingOutcome,
  TrainingProgress,
} from "../engine/protocol";
import { breathe, SLICE } from "./slices";

let training: { cancelled: boolean } | null = null;

async function experiment(
  { seed, driving }: ExperimentJob,
  report: (report: ExperimentReport) => void,
): Promise<TrainingOutcome> {
  if (training) throw new Error("This worker is training already.");
  const run = { cancelled: false };
  training = run;
  let experiment: SyntheticExperiment | null = null;
  try {
    const start = performance.now();
    experiment = new SyntheticExperiment(seed, driving);
    let progress: TrainingProgress;
    do {
      const slice = performance.now();
      do progress = experiment.step();
      while (!progress.done && performance.now() - slice < SLICE);
      // Waits until the page has it: reports and the outcome travel on different ports.
      await report({ progress, elapsed: (performance.now() - start) / 1000, findings: experiment.findings() });
      await breathe();
    } while (!progress.done && !run.cancelled);
    // What was done before the cancel came is done.
    const cancelled = run.cancelled && !progress.done;
    return { cancelled, reason: cancelled ? "You cancelled; this is the best so far." : (progress.reason ?? "Done.") };
  } finally {
    training = null;
    experiment?.free();
  }
}

export const synthesist: Experimenter = {
  experiment,
  cancelExperiment() {
    if (training) training.cancelled = true;
  },
  draw({ seed, driving }) {
    const drawn = new SyntheticExperiment(seed, driving);
    try {
      return drawn.truth();
    } finally {
      drawn.free();
    }
  },
};
