// For tests: small studies, and trials and answers of them.
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";
import bundled from "../../public/study/walks.study.json?raw";

interface Document {
  design: Record<string, unknown>;
  stimuli: { id: string; kind: string }[];
}

const document = JSON.parse(bundled) as Document;
const first = (kind: string) => document.stimuli.find((stimulus) => stimulus.kind === kind)!;
const stimuli = [first("natural"), first("generated")] as const;
const few = { blocks: 2, comparisons: 3, attention_checks: 0, catch_trials: 0 };

/** The document of a study of two movements: two trials, a pause and a third trial. */
export const studyText = (title: string): string =>
  JSON.stringify({ ...document, title, design: { ...document.design, ...few }, stimuli });

/** The file of a participant who saw the natural movement on the left, and gave these answers. */
export function answersText(participant: string, ...responses: ("left" | "right")[]): string {
  const trial = ["comparison", ...stimuli.map(({ id }) => id), "left"];
  const rows = responses.map((response, place) => [place, participant, ...trial, response].join());
  return ["trial_index,participant,kind,left,right,natural_side,response", ...rows].join("\n");
}

export const study: StudyInfo = {
  title: "Two dots",
  hash: "0123456789abcdef",
  look: "figure",
  framesPerSecond: 30,
  seconds: 1,
  crossSeconds: 0.1,
  answerDuringMovement: false,
  pauseSeconds: 5,
  texts: {
    consent: "You may stop at any time.\n\nDo you agree?",
    instructions: "Look at the cross.",
    question: "On which side?",
    pause: "Take a rest.",
    end: "Thank you.",
  },
  frames: 30,
  design: {
    ...{ blocks: 2, comparisons: 3, attentionChecks: 0, catchTrials: 0, seed: 1 },
    ...{ pauseSeconds: 5, answerDuringMovement: false },
  },
  skeleton: {
    names: ["Hips", "Head"],
    parents: [-1, 0],
    joints: 2,
    head: 1,
    feet: null,
    dots: [0, 1],
    height: 1.7,
  },
  stimuli: [
    {
      ...{ id: "walk-1", kind: "natural", trial: "walk-1", speed: 1, seen: true, failed: false },
      ...{ model: null, settings: null, scores: null },
    },
    {
      ...{ id: "tmp-1", kind: "generated", trial: "walk-1", speed: 1, seen: false, failed: false },
      ...{ model: "tmp", settings: { model: "tmp", primitives: 3 } },
      scores: { mse: 0.01, dtwMse: 0.008, trainingMse: 0.004, bound: null, dynamics: null, pose: null },
    },
  ],
};

/** Trials of these numbers in each block; the natural movement is left and right in turn. */
export const trialsOf = (blocks: readonly number[]): StudyTrial[] =>
  blocks.flatMap((count, block) =>
    Array.from({ length: count }, (_, i): StudyTrial => {
      const [left, right] = i % 2 === 0 ? [0, 1] : [1, 0];
      return {
        block,
        kind: "comparison",
        left,
        right,
        naturalSide: left === 0 ? "left" : "right",
        headingDegrees: 90,
      };
    }),
  );
