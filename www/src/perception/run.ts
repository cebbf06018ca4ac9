// Runs an experiment with one participant in jsPsych: takes the remaining steps and gives rows of answers.
import { initJsPsych } from "jspsych";
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";
import { pairPlugin } from "./pair-plugin";
import type { PairStage } from "./pair-stage";
import type { Row } from "./participation";
import { confusionOf, simulatedAnswer } from "./simulated";
import { shownText } from "./standard-texts";
import { type Step, trialColumns } from "./steps";
import { TextPlugin } from "./text-plugin";

export interface Experiment {
  study: StudyInfo;
  steps: readonly Step[];
  /** The columns that are equal in all rows. */
  columns: Row;
  /** Whether the program gives the answers. */
  simulated: boolean;
  /** Stores a row; the next step waits until it is stored. */
  keep(row: Row): Promise<void>;
  /** A step begins. */
  begins(step: Step): void;
}

export interface Running {
  /** Ends after the last step, or when the participant has left. */
  over: Promise<void>;
  leave(): void;
}

/** Runs the steps in the element. */
export function run(display: HTMLElement, stage: PairStage, experiment: Experiment): Running {
  const { study, steps, columns, simulated, keep, begins } = experiment;
  let left = false;
  const jsPsych = initJsPsych({ display_element: display });
  jsPsych.data.addProperties(columns);
  const confusion = simulated ? confusionOf(study) : [];
  const simulation = (trial: StudyTrial) =>
    simulated
      ? { simulation_options: { data: { response: simulatedAnswer(trial, confusion, Math.random()) } } }
      : {};
  const PairPlugin = pairPlugin(stage);
  const timeline = steps.map((step) => ({
    ...(step.kind === "text"
      ? { type: TextPlugin, text: step }
      : {
          ...{
            type: PairPlugin,
            pair: step.trial,
            question: shownText("question", study.texts.question),
            data: trialColumns(study, step),
          },
          ...{
            cross: study.crossSeconds,
            movement: study.seconds,
            answer_during_movement: study.answerDuringMovement,
          },
          ...simulation(step.trial),
        }),
    on_start: () => begins(step),
    on_finish: (row: Row) => (left ? undefined : keep({ ...row })),
  }));
  const over = simulated ? jsPsych.simulate(timeline, "visual") : jsPsych.run(timeline);
  return {
    over,
    leave() {
      if (left) return;
      left = true;
      jsPsych.abortExperiment("");
    },
  };
}
