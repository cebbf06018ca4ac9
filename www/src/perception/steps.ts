// What a participant goes through, step by step: pages of text and pairs of movements. No rendering.
import type { StudyInfo, StudyTrial } from "../engine/whole-protocol";

/** What a page of text is for; the participant reads it and goes on. */
export type TextPage = "consent" | "instructions" | "pause" | "end";

export interface TextStep {
  kind: "text";
  page: TextPage;
  paragraphs: string[];
  /** What the button says. */
  onward: string;
  /** Seconds before the participant can go on. */
  wait: number;
}

export interface PairStep {
  kind: "pair";
  /** Its place among all trials of the participant, from 0. */
  position: number;
  trial: StudyTrial;
}

export type Step = TextStep | PairStep;

/** Paragraphs stand apart by empty lines. */
export const paragraphsOf = (text: string): string[] =>
  text
    .split(/\n\s*\n/)
    .map((paragraph) => paragraph.trim())
    .filter(Boolean);

/**
 * The steps that are left after so many trials. Who takes an experiment up again reads the instructions once
 * more.
 */
export function stepsOf(
  { texts, pauseSeconds }: StudyInfo,
  trials: readonly StudyTrial[],
  answered: number,
): Step[] {
  const page = (page: TextPage, onward: string, wait = 0): TextStep => ({
    ...{ kind: "text", page, paragraphs: paragraphsOf(texts[page]), onward, wait },
  });
  const steps: Step[] = answered === 0 ? [page("consent", "I agree")] : [];
  steps.push(page("instructions", answered === 0 ? "Begin" : "Go on"));
  trials.forEach((trial, position) => {
    if (position < answered) return;
    const before = trials[position - 1];
    if (position > answered && before && before.block !== trial.block)
      steps.push(page("pause", "Go on", pauseSeconds));
    steps.push({ kind: "pair", position, trial });
  });
  return [...steps, page("end", "Done")];
}
