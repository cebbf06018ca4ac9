// Drawings of many kinds, made by formulas with a hand's trembling, uneven tempo and uneven moments of a
// pointer: loops, corners, letters, shapes drawn once, rests, slow starts, pens that are lifted.
import type { Sample, Strokes } from "./hand";

type Shape = (turn: number) => [number, number];

/** Random numbers from 0 to 1 by a seed (mulberry32). */
function randomOf(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A closed or an open line through corners, "x y, x y", at an even speed. */
function through(text: string, isClosed: boolean): Shape {
  const corners = text.split(", ").map((corner) => corner.split(" ").map(Number) as [number, number]);
  const all = isClosed ? [...corners, corners[0] ?? [0, 0]] : corners;
  const lengths = all.slice(1).map(([x, y], i) => Math.hypot(x - (all[i]?.[0] ?? 0), y - (all[i]?.[1] ?? 0)));
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  return (turn) => {
    let rest = (turn - Math.floor(turn) || (turn > 0 && !isClosed && Number.isInteger(turn) ? 1 : 0)) * whole;
    let i = 0;
    while (i < lengths.length - 1 && rest > (lengths[i] ?? 0)) rest -= lengths[i++] ?? 0;
    const [[a, b], [c, d]] = [all[i] ?? [0, 0], all[i + 1] ?? [0, 0]];
    const share = rest / (lengths[i] || 1);
    return [a + share * (c - a), b + share * (d - b)];
  };
}

const round = (turn: number) => 2 * Math.PI * turn;
const star = [0, 2, 4, 1, 3].map((k) => `${Math.sin(round(k / 5))} ${Math.cos(round(k / 5))}`).join(", ");
const SHAPES: Record<string, Shape> = {
  circle: (t) => [Math.cos(round(t)), Math.sin(round(t))],
  ellipse: (t) => [1.2 * Math.cos(round(t)), 0.4 * Math.sin(round(t))],
  eight: (t) => [Math.sin(round(t)), 0.7 * Math.sin(2 * round(t))],
  lying: (t) => [1.2 * Math.cos(round(t)), 0.6 * Math.sin(2 * round(t))],
  heart: (t) => {
    const a = round(t);
    const y = 13 * Math.cos(a) - 5 * Math.cos(2 * a) - 2 * Math.cos(3 * a) - Math.cos(4 * a);
    return [Math.sin(a) ** 3, y / 16];
  },
  star: through(star, true),
  square: through("-1 -1, 1 -1, 1 1, -1 1", true),
  triangle: through("-1 -0.8, 1 -0.8, 0 1", true),
  zigzag: (t) => [1.2 * Math.sin(round(t)), 0.5 * Math.sin(6 * round(t) + 1)],
  line: (t) => [Math.cos(round(t)), 0.3 * Math.cos(round(t))],
  flower: (t) => [
    (0.7 + 0.3 * Math.cos(5 * round(t))) * Math.cos(round(t)),
    (0.7 + 0.3 * Math.cos(5 * round(t))) * Math.sin(round(t)),
  ],
  clover: (t) => [Math.cos(3 * round(t)) * Math.cos(round(t)), Math.cos(3 * round(t)) * Math.sin(round(t))],
  bean: (t) => [Math.cos(round(t)) + 0.4 * Math.cos(2 * round(t)), Math.sin(round(t))],
  wave: (t) => [2 * t - 1, 0.6 * Math.sin(2.5 * round(t))],
  spiral: (t) => [(0.2 + 0.8 * t) * Math.cos(3 * round(t)), (0.2 + 0.8 * t) * Math.sin(3 * round(t))],
  a: (t) =>
    t < 0.7
      ? [0.6 * Math.cos(round(0.1 + t / 0.7)), 0.6 * Math.sin(round(0.1 + t / 0.7))]
      : [0.6, 0.5 - 1.1 * ((t - 0.7) / 0.3)],
  e: (t) => [
    t < 0.3 ? -0.6 + 4 * t : 0.6 * Math.cos(round((t - 0.3) * 1.15)),
    t < 0.3 ? 0 : 0.6 * Math.sin(round((t - 0.3) * 1.15)),
  ],
  s: (t) => [0.6 * Math.cos(1.5 * Math.PI * 2 * t + 0.7), 1 - 2 * t],
  m: through("-1 -1, -0.8 1, 0 -0.6, 0.8 1, 1 -1", false),
  z: through("-1 1, 1 1, -1 -1, 1 -1", false),
  hook: (t) => [
    t < 0.5 ? -0.5 : -0.5 + 2 * (t - 0.5),
    t < 0.5 ? 1 - 3 * t : -0.5 + 0.6 * Math.sin(round(t - 0.5)),
  ],
};

export interface Hand {
  shape: keyof typeof SHAPES;
  /** How often it is drawn, and the seconds of one lap. */
  laps: number;
  lap: number;
  seed: number;
  size?: number;
  /** Seconds of rest before, in the middle and after. */
  rests?: readonly [number, number, number];
  /** The pen is lifted between laps. */
  lifted?: boolean;
  /** How much lap differs from lap. */
  uneven?: number;
}

/** What a pointer reports while a hand draws. */
export function strokesOf({
  shape,
  laps,
  lap,
  seed,
  size = 30,
  rests = [0, 0, 0],
  lifted,
  uneven = 1,
}: Hand): Strokes {
  const random = randomOf(seed);
  const drift = () => (random() + random() + random() - 1.5) * uneven;
  const of = SHAPES[shape] ?? (() => [0, 0]);
  const strokes: Sample[][] = [[]];
  let seconds = 0;
  let [dx, dy, tempo] = [0, 0, 1];
  const put = (turn: number) => {
    const [x, y] = of(turn);
    dx += 0.12 * drift() - 0.03 * dx;
    dy += 0.12 * drift() - 0.03 * dy;
    strokes.at(-1)?.push({ seconds, x: 50 + size * x + dx, y: 66 + size * y + dy });
  };
  const rest = (length: number, turn: number) => {
    for (const end = seconds + length; seconds < end; seconds += 0.012 + 0.006 * random()) put(turn);
  };
  rest(rests[0], 0);
  let turn = 0;
  let isRested = rests[1] === 0;
  while (turn < laps) {
    if (!isRested && turn > laps / 2) {
      rest(rests[1], turn);
      isRested = true;
    }
    put(turn);
    const step = 0.008 + 0.009 * random();
    seconds += step;
    tempo += 0.03 * drift() - 0.05 * (tempo - 1);
    // A hand begins and ends slowly.
    const ease = Math.min(1, 0.2 + 6 * Math.min(turn, laps - turn));
    const next = turn + (step / lap) * tempo * ease;
    if (lifted && Math.floor(next) > Math.floor(turn) && next < laps) {
      seconds += 0.25 + 0.15 * random();
      strokes.push([]);
    }
    turn = next;
  }
  rest(rests[2], laps - 1e-6);
  return strokes;
}

/** Thirty drawings. */
export const HANDS: readonly Hand[] = [
  { shape: "circle", laps: 4, lap: 1, seed: 1 },
  { shape: "circle", laps: 6, lap: 0.6, seed: 2, size: 15 },
  { shape: "circle", laps: 1, lap: 1.2, seed: 3 },
  { shape: "circle", laps: 3, lap: 1.4, seed: 4, uneven: 2.5 },
  { shape: "ellipse", laps: 5, lap: 0.9, seed: 5 },
  { shape: "eight", laps: 4, lap: 1.3, seed: 6 },
  { shape: "eight", laps: 1, lap: 1.5, seed: 7 },
  { shape: "lying", laps: 5, lap: 1.2, seed: 8, size: 20 },
  { shape: "heart", laps: 3, lap: 1.8, seed: 9 },
  { shape: "heart", laps: 1, lap: 2, seed: 10 },
  { shape: "star", laps: 3, lap: 2.2, seed: 11 },
  { shape: "star", laps: 1, lap: 2.5, seed: 12 },
  { shape: "square", laps: 4, lap: 1.6, seed: 13 },
  { shape: "square", laps: 1, lap: 2, seed: 14 },
  { shape: "triangle", laps: 4, lap: 1.4, seed: 15 },
  { shape: "zigzag", laps: 2.5, lap: 2.4, seed: 16, size: 25 },
  { shape: "line", laps: 6, lap: 0.8, seed: 17 },
  { shape: "flower", laps: 3, lap: 2.4, seed: 18 },
  { shape: "clover", laps: 4, lap: 1.8, seed: 19 },
  { shape: "bean", laps: 4, lap: 1.1, seed: 20, rests: [0.8, 0, 0.6] },
  { shape: "circle", laps: 5, lap: 1, seed: 21, rests: [0.2, 1.2, 0.2] },
  { shape: "wave", laps: 1, lap: 2, seed: 22 },
  { shape: "spiral", laps: 1, lap: 3, seed: 23 },
  { shape: "a", laps: 1, lap: 1.4, seed: 24 },
  { shape: "a", laps: 3, lap: 1.2, seed: 25, lifted: true },
  { shape: "e", laps: 1, lap: 1.3, seed: 26 },
  { shape: "s", laps: 1, lap: 1, seed: 27 },
  { shape: "m", laps: 1, lap: 1.6, seed: 28 },
  { shape: "z", laps: 2, lap: 1.2, seed: 29, lifted: true },
  { shape: "hook", laps: 1, lap: 0.9, seed: 30, size: 12 },
];

/**
 * Two hands for each of these drawings: while it is played, whose round has these seconds, the second hand draws a
 * closed shape a little slower or faster.
 */
export function beside(place: number, round: number): Hand {
  const lap = round * (0.92 + 0.16 * (((place * 7919 + 13) % 100) / 100));
  const { shape = "circle" } = HANDS[(place + 7) % 20] ?? {};
  return { shape, lap, laps: Math.max(3, Math.round(5 / lap)), seed: 500 + place };
}
