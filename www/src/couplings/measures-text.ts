// What the body was measured to do, in plain words, beside what it does as learned.
import type { BodyReport, Health } from "../engine/protocol";

export interface MeasuresText {
  /** What the hands and feet of each part do. */
  parts: { part: number; words: string }[];
  /** Whether hands and feet are in step, where it is the same for all; empty where nothing has a step. */
  step: string;
  /** How the motion ends where it does not go on; else empty. */
  trouble: string;
}

/**
 * A hand or foot that swings less, in metres, swings so little that its share of the learned swing says
 * nothing.
 */
const SWINGS = 0.01;
/** Less of the learned swing is hardly a swing. */
const HARDLY = 0.1;
/** Paces that differ by less are the same. */
const SAME_PACE = 0.05;
const SAME_SPEED = 0.1;
/** From where on two limbs are in step, and up to where they are out of step. */
const IN_STEP = 0.9;
const OUT_OF_STEP = 0.5;

type Limbs = BodyReport["measures"]["parts"][number];

export function measuresText(now: BodyReport, learned: BodyReport, names: readonly string[]): MeasuresText {
  const trouble = troubleText(now.health, names);
  // A figure that stands still has nothing to swing.
  if (now.health.state === "stands still" || now.health.state === "not finite")
    return { parts: [], step: "", trouble };
  const steps = new Set(now.measures.parts.map(stepWord).filter(Boolean));
  const parts = names.flatMap((_, part) => {
    const [is, was] = [now.measures.parts[part], learned.measures.parts[part]];
    if (!is || !was || is.swing === null || was.swing === null) return [];
    const words = [swingWords(is.swing, was.swing), paceWords(is, was), steps.size > 1 ? stepWord(is) : ""];
    return { part, words: words.filter(Boolean).join(", ") };
  });
  const common = steps.size === 1 ? [...steps].join() : "";
  const step = [common && `hands and feet ${common}`, speedWords(now, learned)].filter(Boolean).join("; ");
  return { parts, step, trouble };
}

function swingWords(is: number, was: number): string {
  if (was < SWINGS) return `swings ${(100 * is).toFixed(0)} cm`;
  const share = is / was;
  return `${share < HARDLY ? "hardly swings, " : "swings "}${share.toFixed(2)} × as far`;
}

function paceWords({ period: is }: Limbs, { period: was }: Limbs): string {
  if (is === null || was === null || Math.abs(is / was - 1) < SAME_PACE) return "";
  return `${is > was ? "slower" : "faster"} (${is.toFixed(2)} s, not ${was.toFixed(2)} s)`;
}

function stepWord({ locking }: Limbs): string {
  if (locking === null) return "";
  return locking >= IN_STEP ? "in step" : locking > OUT_OF_STEP ? "partly in step" : "out of step";
}

/** In place of the speeds, how one is to the other: a body on the spot has none. */
function speedWords(
  { measures: { walkingSpeed: is } }: BodyReport,
  { measures: { walkingSpeed: was } }: BodyReport,
): string {
  const share = is / was;
  return was < 0.1 || Math.abs(share - 1) < SAME_SPEED ? "" : `walks ${share.toFixed(2)} × as fast`;
}

/** How a motion ends where it does not go on, in words to follow "it"; else empty. */
export function troubleText({ state, from, part }: Health, names: readonly string[]): string {
  const since = `from ${(from ?? 0).toFixed(1)} s on`;
  switch (state) {
    case "stands still":
      return `stands still ${since}`;
    case "leaves the training range":
      return `${names[part ?? 0] ?? "a part"} leaves the training range ${since}`;
    case "not finite":
      return "runs away: its numbers are too large to show";
    default:
      return "";
  }
}
