// The measures of a motion as text, compared with the motion as learned.
import type { BodyReport, Health } from "../engine/protocol";

export interface MeasuresText {
  /** How the hands and feet of each part swing. */
  parts: { part: number; words: string }[];
  /** Whether hands and feet are in step, if this is the same for all parts; else empty. */
  step: string;
  /** How the motion ends, if it does not move on; else empty. */
  trouble: string;
}

/** Metres. A ratio to a smaller learned swing has no meaning. */
const SWINGS = 0.01;
/** A smaller share of the learned swing is "hardly" a swing. */
const HARDLY = 0.1;
/** Relative differences below these are not reported. */
const SAME_PACE = 0.05;
const SAME_SPEED = 0.1;
/** Two limbs are in step from the first value of the locking on, and out of step up to the second. */
const IN_STEP = 0.9;
const OUT_OF_STEP = 0.5;

type Limbs = BodyReport["measures"]["parts"][number];

export function measuresText(now: BodyReport, learned: BodyReport, names: readonly string[]): MeasuresText {
  const trouble = troubleText(now.health, names);
  if (now.health.state === "stands-still" || now.health.state === "not-finite")
    return { parts: [], step: "", trouble };
  const steps = new Set(now.measures.parts.map(stepText).filter(Boolean));
  const parts = names.flatMap((_, part) => {
    const [is, was] = [now.measures.parts[part], learned.measures.parts[part]];
    if (!is || !was || is.swing === null || was.swing === null) return [];
    const texts = [swingText(is.swing, was.swing), paceText(is, was), steps.size > 1 ? stepText(is) : ""];
    return { part, words: texts.filter(Boolean).join(", ") };
  });
  const common = steps.size === 1 ? [...steps].join() : "";
  const step = [common && `hands and feet ${common}`, speedText(now, learned)].filter(Boolean).join("; ");
  return { parts, step, trouble };
}

/** Whether hands or feet still swing, compared with the motion as learned. */
export function isSwinging({ swing: is }: Limbs, { swing: was }: Limbs): boolean {
  return is !== null && was !== null && (was < SWINGS || is / was >= HARDLY);
}

function swingText(is: number, was: number): string {
  if (was < SWINGS) return `swings ${(100 * is).toFixed(0)} cm`;
  const share = is / was;
  return `${share < HARDLY ? "hardly swings, " : "swings "}${share.toFixed(2)} × as far`;
}

function paceText({ period: is }: Limbs, { period: was }: Limbs): string {
  if (is === null || was === null || Math.abs(is / was - 1) < SAME_PACE) return "";
  return `${is > was ? "slower" : "faster"} (${is.toFixed(2)} s, not ${was.toFixed(2)} s)`;
}

export type Step = "in step" | "partly in step" | "out of step";

/** The step of two limbs or parts whose phase difference has this constancy, 0 to 1. */
export function stepOf(locking: number): Step {
  return locking >= IN_STEP ? "in step" : locking > OUT_OF_STEP ? "partly in step" : "out of step";
}

function stepText({ locking }: Limbs): string {
  return locking === null ? "" : stepOf(locking);
}

/** The ratio of the speeds; empty for a body that walks on the spot. */
function speedText(
  { measures: { walkingSpeed: is } }: BodyReport,
  { measures: { walkingSpeed: was } }: BodyReport,
): string {
  const share = is / was;
  return was < 0.1 || Math.abs(share - 1) < SAME_SPEED ? "" : `walks ${share.toFixed(2)} × as fast`;
}

/** How a motion ends, if it does not move on: the rest of a sentence that begins with "it". Else empty. */
export function troubleText({ state, from, part }: Health, names: readonly string[]): string {
  const since = `from ${(from ?? 0).toFixed(1)} s on`;
  switch (state) {
    case "stands-still":
      return `stands still ${since}`;
    case "leaves-training-range":
      return `${names[part ?? 0] ?? "a part"} leaves the training range ${since}`;
    case "not-finite":
      return "runs away: its numbers are too large to show";
    default:
      return "";
  }
}
