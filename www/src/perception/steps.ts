// The steps of a participant: pages of text and pairs of movements. No rendering.
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";
import { perceptionWords } from "./view-words";
import type { Row } from "./participation";
import { shownText } from "./standard-texts";

/** The purpose of a page of text. */
export type TextPage = "consent" | "instructions" | "pause" | "end";

export interface TextStep {
  kind: "text";
  page: TextPage;
  paragraphs: string[];
  /** The label of the button. */
  onward: string;
  /** Seconds before the button works. */
  wait: number;
}

export interface PairStep {
  kind: "pair";
  /** Its place among all trials of the participant, from 0. */
  position: number;
  trial: StudyTrial;
}

export type Step = TextStep | PairStep;

/** The columns of a trial besides the answer. */
export function trialColumns({ stimuli }: StudyInfo, { position, trial }: Omit<PairStep, "kind">): Row {
  const { block, kind, left, right, naturalSide, headingDegrees } = trial;
  const id = (stimulus: number) => stimuli[stimulus]?.id ?? "";
  return {
    ...{ position, block, kind, left: id(left), right: id(right) },
    ...{ natural_side: naturalSide, heading: headingDegrees },
  };
}

/** The paragraphs of a text; empty lines separate them. */
export const paragraphsOf = (text: string): string[] =>
  text
    .split(/\n\s*\n/)
    .map((paragraph) => paragraph.trim())
    .filter(Boolean);

/**
 * The steps that remain after a number of trials. A participant who continues reads the instructions again.
 */
export function stepsOf(
  { texts, pauseSeconds }: StudyInfo,
  trials: readonly StudyTrial[],
  answered: number,
): Step[] {
  const page = (page: TextPage, onward: string, wait = 0): TextStep => ({
    ...{ kind: "text", page, paragraphs: paragraphsOf(shownText(page, texts[page])), onward, wait },
  });
  const words = perceptionWords().run;
  const steps: Step[] = answered === 0 ? [page("consent", words.agree)] : [];
  steps.push(page("instructions", answered === 0 ? words.begin : words.goOn));
  trials.forEach((trial, position) => {
    if (position < answered) return;
    const before = trials[position - 1];
    if (position > answered && before && before.block !== trial.block)
      steps.push(page("pause", words.goOn, pauseSeconds));
    steps.push({ kind: "pair", position, trial });
  });
  return [...steps, page("end", words.done)];
}
