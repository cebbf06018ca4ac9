// The measures of a motion as text, compared with the motion as learned.
import type { BodyReport, Health } from "../engine/protocol";
import { lab } from "../words/lab";

export interface MeasuresText {
  /** How the hands and feet of each part swing; `changed`: not as learned. */
  parts: { part: number; words: string; changed: boolean }[];
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
const SAME_SWING = 0.1;
const SAME_PACE = 0.05;
const SAME_SPEED = 0.1;
/** Two limbs are in step from the first value of the locking on, and out of step up to the second. */
const IN_STEP = 0.9;
const OUT_OF_STEP = 0.5;

type Limbs = BodyReport["measures"]["parts"][number];

export function measuresText(now: BodyReport, learned: BodyReport, names: readonly string[]): MeasuresText {
  const trouble = troubleText(now.health, names);
  if (IN_ONE_POSE.has(now.health.state) || now.health.state === "not-finite")
    return { parts: [], step: "", trouble };
  const steps = new Set(now.measures.parts.map(stepText).filter(Boolean));
  const all = names.flatMap((_, part) => {
    const [is, was] = [now.measures.parts[part], learned.measures.parts[part]];
    if (!is || !was || is.swing === null || was.swing === null) return [];
    const since = now.health.parts[part]?.stillFrom ?? null;
    const pose = since === null ? "" : lab().measured.still(sinceText(since));
    const pace = paceText(is, was);
    const texts = pose ? [pose] : [swingText(is.swing, was.swing), pace];
    const changed = pose !== "" || pace !== "" || !isSame(is.swing, was.swing);
    return { part, texts, changed, step: stepText(is), stepChanged: stepText(is) !== stepText(was) };
  });
  // Two parts lose the step with each other. Where only some parts move in another way, the step is theirs.
  const some = all.some(({ changed }) => changed);
  const parts = all.map(({ part, texts, changed, step, stepChanged }) => {
    const own = steps.size > 1 && (changed || !stepChanged || !some);
    return { part, words: [...texts, own ? step : ""].filter(Boolean).join(", "), changed };
  });
  const common = steps.size === 1 ? [...steps].join() : "";
  const step = [common && lab().measured.common(common), speedText(now, learned)].filter(Boolean).join("; ");
  return { parts, step, trouble };
}

/** Whether hands or feet still swing, compared with the motion as learned. */
export function isSwinging({ swing: is }: Limbs, { swing: was }: Limbs): boolean {
  return is !== null && was !== null && (was < SWINGS || is / was >= HARDLY);
}

function isSame(is: number, was: number): boolean {
  return was < SWINGS ? is < SWINGS : Math.abs(is / was - 1) < SAME_SWING;
}

function swingText(is: number, was: number): string {
  const { swings, swingsBy } = lab().measured;
  return was < SWINGS ? swingsBy(100 * is) : swings(is / was, is / was < HARDLY);
}

function paceText(now: Limbs, learned: Limbs): string {
  const [is, was] = [now.period, learned.period];
  if (was === null || !isSwinging(now, learned)) return "";
  if (is === null) return lab().measured.noPace;
  if (Math.abs(is / was - 1) < SAME_PACE) return "";
  return lab().measured.pace(is, was);
}

export type Step = "in step" | "partly in step" | "out of step";

/** The step of two limbs or parts whose phase difference has this constancy, 0 to 1. */
export function stepOf(locking: number): Step {
  return locking >= IN_STEP ? "in step" : locking > OUT_OF_STEP ? "partly in step" : "out of step";
}

function stepText({ locking }: Limbs): string {
  return locking === null ? "" : lab().measured.step[stepOf(locking)];
}

/** The ratio of the speeds; empty for a body that walks on the spot. */
function speedText(
  { measures: { walkingSpeed: is } }: BodyReport,
  { measures: { walkingSpeed: was } }: BodyReport,
): string {
  const share = is / was;
  return was < 0.1 || Math.abs(share - 1) < SAME_SPEED ? "" : lab().measured.speed(share);
}

/** The states of a body whose pose hardly changes. */
const IN_ONE_POSE: ReadonlySet<Health["state"]> = new Set(["stands-still", "keeps-one-pose"]);

const sinceText = (seconds: number) => lab().measured.since(seconds);

/** How a motion ends, if it does not move on: the rest of a sentence that begins with "it". Else empty. */
export function troubleText({ state, from, part, parts, pace }: Health, names: readonly string[]): string {
  const words = lab().measured;
  const since = sinceText(from ?? 0);
  const name = names[part ?? 0] ?? words.aPart;
  switch (state) {
    case "stands-still":
      return words.standsStill(since);
    case "keeps-one-pose":
      return words.pose(since);
    case "visits-few-poses":
      return words.visits(parts[part ?? 0]?.visited ?? 0, name);
    case "leaves-training-range":
      return words.leaves(name, since);
    case "shakes": {
      const own = (part === null ? pace : parts[part]?.pace) ?? null;
      return words.shakes(part === null ? null : name, own?.times ?? null, own?.turnsBack ?? 0);
    }
    case "not-finite":
      return words.runsAway;
    default:
      return "";
  }
}
