// The texts over the figure: a title, and what it is about.
import type { StageContent } from "../stage/stage-store";
import { clipTitle } from "../ui/format";
import { lab } from "../words/lab";

/** The state of the stage that the texts need. */
export interface OnStage {
  /** Null: the stage is empty. */
  kind: StageContent["kind"] | null;
  clip: { title: string; origin: "made" | "model" | "own"; note?: string } | null;
  /** The names of the model's training sequences; null without a model. */
  learnedFrom: readonly string[] | null;
  /** The description of the inducing point under the pointer. */
  point: string | null;
  /** Whether a coupling is changed. */
  altered: boolean;
  /** The preset of the couplings. */
  preset: { name: string } | null;
  /** Whether the motion is live. */
  live: boolean;
  /** The seed of the sampled motion; absent: the mean. */
  sample?: number | undefined;
  /** Whether both readings of the couplings are side by side. */
  twoReadings: boolean;
  /** The running training whose model is on the stage; `iteration` is null before the first. */
  learning: { iteration: number | null; seed: number | null } | null;
}

export interface StageWords {
  title: string;
  text: string;
}

/** The most clips that are named; more are counted. */
const NAMED = 2;

export function stageWords(now: OnStage): StageWords {
  const { kind, clip } = now;
  if (kind === null) return { title: "", text: "" };
  if (kind === "clip") return clipWords(clip);
  return modelWords(now);
}

function clipWords(clip: OnStage["clip"]): StageWords {
  const words = lab().stage;
  return {
    title: clip?.title ?? words.clip,
    text: clip?.note || words.clipFrom[clip?.origin ?? "own"],
  };
}

function modelWords(now: OnStage): StageWords {
  const { point, altered, preset, twoReadings, live, learning, learnedFrom, sample } = now;
  const words = lab().stage;
  if (point !== null) return { title: words.point, text: point };
  if (sample && !live) return words.sampled(sample);
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
