// The texts of the page about the stage: title and text over the figure, and the sentence in the header. One
// file makes all of them, so that they agree.
import { readingSentence } from "../couplings/reading-text";
import type { Reading } from "../engine/protocol";
import type { StageContent } from "../stage/stage-store";
import { clipTitle } from "../ui/format";
import { lab } from "../words/lab";

/** The state of the stage that the texts need. */
export interface OnStage {
  /** Null: the stage is empty. */
  kind: StageContent["kind"] | null;
  clip: { title: string; origin: "made" | "model" | "own" } | null;
  /** The names of the model's training sequences; null without a model. */
  learnedFrom: readonly string[] | null;
  /** The description of the inducing point under the pointer. */
  point: string | null;
  /** Whether a coupling is changed. */
  altered: boolean;
  /** The preset of the couplings. */
  preset: { name: string; meaning: string } | null;
  /** The measured effect of the couplings, and the reading of the motion; null while not measured. */
  effect: { text: string; reading: Reading } | null;
  /** Whether the motion is live. */
  live: boolean;
  /** Whether both readings of the couplings are side by side. */
  twoReadings: boolean;
  /** The running training whose model is on the stage; `iteration` is null before the first. */
  learning: { iteration: number | null; seed: number | null } | null;
}

export interface StageWords {
  title: string;
  text: string;
  lead: string;
}

/** The most clips that are named; more are counted. */
const NAMED = 2;

export function stageWords(now: OnStage): StageWords {
  const { kind, clip } = now;
  if (kind === null) return { title: "", text: "", lead: lab().stage.lead.made };
  if (kind === "clip") return clipWords(clip);
  const lead = now.altered ? alteredLead(now) : now.learning ? lab().stage.lead.learning : learned(now);
  return { ...modelWords(now), lead };
}

function alteredLead({ preset, effect, live, twoReadings }: OnStage): string {
  const meaning = preset?.meaning ?? lab().stage.lead.own;
  return effect && !live
    ? `${meaning} ${readingSentence(effect.text, effect.reading, twoReadings)}`
    : meaning;
}

function learned({ learnedFrom }: OnStage): string {
  const count = learnedFrom?.length ?? 0;
  const { lead, clips } = lab().stage;
  return count === 0 ? lead.made : lead.learned(clips(count));
}

function clipWords(clip: OnStage["clip"]): StageWords {
  const words = lab().stage;
  return {
    title: clip?.title ?? words.clip,
    text: clip ? words.clipFrom[clip.origin] : words.clipFrom.own,
    lead: words.lead.clip,
  };
}

function modelWords(now: OnStage): { title: string; text: string } {
  const { point, altered, preset, twoReadings, live, learning, learnedFrom } = now;
  const words = lab().stage;
  if (point !== null) return { title: words.point, text: point };
  if (altered) {
    const title = preset?.name ?? words.changed;
    if (live) return { title, text: words.live };
    return {
      title,
      text: twoReadings ? words.twoReadings : words.outline,
    };
  }
  if (twoReadings) return { title: words.made, text: words.changeOne };
  if (learning) {
    const { iteration, seed } = learning;
    const text = iteration === null ? words.starting : words.iteration(iteration, seed);
    return { title: words.learning, text };
  }
  return { title: words.made, text: namesOf(learnedFrom ?? []) };
}

function namesOf(names: readonly string[]): string {
  if (names.length === 0) return "";
  const titles = names.map(clipTitle);
  const { learnedFrom, clips, and } = lab().stage;
  return learnedFrom(titles.length > NAMED ? clips(titles.length) : and(titles));
}
