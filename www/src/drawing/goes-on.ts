// Whether a model goes on as a hand drew: a measure that was written down before anything was measured with
// it. All thresholds are ours. No DOM.
import { ROWS_A_SECOND, type Rows } from "./hand";

/** The end of the rollout that is compared is this long, in rows, or a lap. */
const END = 5 * ROWS_A_SECOND;
/** A place is the same within this share of the drawing's extent. */
const NEAR = 0.15;
/** As much of the drawing must be visited, and as much of the rollout must be on it. */
const SHARE = 0.8;
/** The speed and the spread of the rollout, divided by those of the drawing. */
const SPEED = [0.5, 2] as const;

export interface GoesOn {
  /** The share of the drawing that the end of the rollout visits, and of the rollout that is on the drawing. */
  visited: number;
  on: number;
  /** The mean speed divided by the drawing's. */
  speed: number;
  goesOn: boolean;
}

const speedOf = (rows: Rows) =>
  rows.slice(1).reduce((sum, [x = 0, y = 0], i) => {
    const [a = 0, b = 0] = rows[i] ?? [];
    return sum + Math.hypot(x - a, y - b);
  }, 0) / Math.max(1, rows.length - 1);

function shareNear(these: Rows, those: Rows, near: number): number {
  const isNear = ([x = 0, y = 0]: readonly number[]) =>
    those.some(([a = 0, b = 0]) => Math.hypot(x - a, y - b) < near);
  return these.filter(isNear).length / Math.max(1, these.length);
}

/** Compares the end of a rollout with the drawing, on one pad: rows of x and y. */
export function goesOn(drawn: Rows, rollout: Rows, lap: number): GoesOn {
  const end = rollout.slice(-Math.max(END, lap));
  const range = (i: number) => {
    const values = drawn.map((row) => row[i] ?? 0);
    return Math.max(...values) - Math.min(...values);
  };
  const near = NEAR * Math.hypot(range(0), range(1));
  const visited = shareNear(drawn, end, near);
  const on = shareNear(end, drawn, near);
  const speed = speedOf(end) / speedOf(drawn);
  return {
    visited,
    on,
    speed,
    goesOn: Math.min(visited, on) >= SHARE && speed > SPEED[0] && speed < SPEED[1],
  };
}
