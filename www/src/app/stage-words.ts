// The texts of the page about the stage: title and text over the figure, and the sentence in the header. One
// file makes all of them, so that they agree.
import { readingSentence } from "../couplings/reading-text";
import type { Reading } from "../engine/protocol";
import { clipTitle } from "../ui/format";

/** The state of the stage that the texts need. */
export interface OnStage {
  /** Null: the stage is empty. */
  kind: "first" | "model" | "clip" | null;
  clip: { title: string; origin: "made" | "own" } | null;
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

/** The title of a motion of the model, as learned. */
export const MODEL_TITLE = "Made by the model";

/** The most clips that are named; more are counted. */
const NAMED = 2;

export function stageWords(now: OnStage): StageWords {
  const { kind, clip } = now;
  if (kind === null) return { title: "", text: "", lead: MADE };
  if (kind === "clip") return clipWords(clip);
  const lead = now.altered ? alteredLead(now) : now.learning ? LEARNING : learned(now);
  return { ...modelWords(now), lead };
}

const MADE = "This motion was never recorded: a small model made it.";
const LEARNING = "A model is learning: what it can do so far moves on the stage.";

function alteredLead({ preset, effect, live, twoReadings }: OnStage): string {
  const meaning = preset?.meaning ?? "Couplings of your own, not those that the model learned.";
  return effect && !live
    ? `${meaning} ${readingSentence(effect.text, effect.reading, twoReadings)}`
    : meaning;
}

function learned({ learnedFrom }: OnStage): string {
  const count = learnedFrom?.length ?? 0;
  return count === 0
    ? MADE
    : `This motion was never recorded: a small model learned it from ${clipCount(count)}.`;
}

function clipWords(clip: OnStage["clip"]): StageWords {
  const origin = clip?.origin === "made" ? "made by a procedural walker" : "as it was recorded";
  return {
    title: clip?.title ?? "Clip",
    text: `A clip, ${origin}: not the model`,
    lead: "This is a clip: what a model learns from, not what it made.",
  };
}

function modelWords(now: OnStage): { title: string; text: string } {
  const { point, altered, preset, twoReadings, live, learning, learnedFrom } = now;
  if (point !== null) return { title: "What an inducing point stands for", text: point };
  if (altered) {
    const title = preset?.name ?? "Couplings changed";
    if (live) return { title, text: "The model goes on live" };
    return {
      title,
      text: twoReadings
        ? "The same couplings, read in two ways"
        : "The outline moves as the model learned it",
    };
  }
  if (twoReadings) return { title: MODEL_TITLE, text: "change a coupling to see two readings of it" };
  if (learning) {
    const seed = learning.seed === null ? "" : `, seed ${learning.seed}`;
    const text = learning.iteration === null ? "Starting" : `Iteration ${learning.iteration}${seed}`;
    return { title: "The model while it learns", text };
  }
  return { title: MODEL_TITLE, text: namesOf(learnedFrom ?? []) };
}

function namesOf(names: readonly string[]): string {
  if (names.length === 0) return "";
  const titles = names.map(clipTitle);
  return `learned from ${titles.length > NAMED ? clipCount(titles.length) : titles.join(" and ")}`;
}

function clipCount(count: number): string {
  return count === 1 ? "one clip" : `${count} clips`;
}
