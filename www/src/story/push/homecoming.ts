// How far a push takes the parts from their loops, and how long they need to come back.
import type { Mark, TracePoint } from "../../live/live-store";

/** Home is at most this many times as far from the loop as the walk strays without a push. */
const STRAYS = 2;
/** Seconds in which a walk settles on its loop, and seconds after them that show how far it strays. */
const SETTLES = 1;
const UNDISTURBED = 2;
/** Seconds that a part must stay near its loop to be home, and after which it is lost. */
const STAYS = 1;
const LOST = 8;

type Push = Extract<Mark, { kind: "push" }>;

const farthestOf = ({ distances }: TracePoint) => Math.max(0, ...distances);

/** The distance within which the walk is home, in radii of the loop; null after too few frames. */
export function homeLimit(trace: readonly TracePoint[], frameTime: number): number | null {
  if (trace.length * frameTime < SETTLES + UNDISTURBED) return null;
  return STRAYS * Math.max(...trace.slice(-Math.round(UNDISTURBED / frameTime)).map(farthestOf));
}

export interface Homecoming {
  /** The largest distance of a part from its loop since the push began, in radii of the loop. */
  farthest: number;
  /** Seconds from the end of the push until all parts were near their loops to stay; null: not yet. */
  seconds: number | null;
  /** Whether it is not expected to come home any more. */
  isLost: boolean;
}

/** The way home after a push. */
export function homecoming(
  trace: readonly TracePoint[],
  { began, from }: Push,
  limit: number,
  frameTime: number,
): Homecoming {
  const since = trace.filter(({ frame }) => frame >= began);
  const after = since.filter(({ frame }) => frame >= from);
  const lastAway = after.findLast((point) => farthestOf(point) > limit)?.frame ?? from - 1;
  const newest = after.at(-1)?.frame ?? from;
  const isHome = (newest - lastAway) * frameTime >= STAYS;
  return {
    farthest: Math.max(0, ...since.map(farthestOf)),
    seconds: isHome ? (lastAway + 1 - from) * frameTime : null,
    isLost: !isHome && (newest - from) * frameTime >= LOST,
  };
}
