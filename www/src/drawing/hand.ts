// From what a hand drew to rows that a model learns from: even steps of time, no rests, and a shape that was
// drawn once only is repeated. No DOM.

/** The pen is read so often a second. */
export const READS_A_SECOND = 60;
/** Every third reading is a row of the table: from row to row the pen should move visibly. */
const EVERY = 3;
/** A lap has at most as many rows: a slow drawing has fewer a second, because the pen moves less from row to row. */
const MOST_OF_LAP = 100;
/** The most rows a second of a table. */
export const ROWS_A_SECOND = READS_A_SECOND / EVERY;
/** Readings by which a hand's trembling is smoothed (standard deviation). */
const SMOOTH = 2;
/** A hand rests while it is slower than this share of its usual speed. */
const REST = 0.08;
/** A rest within a drawing is as long as this, in readings: a model cannot know when a longer one ends. */
const LONGEST_REST = 8;
/** A drawing that returns to itself has differences of at most this share of its variance. */
const RETURNS = 0.12;
/** And it was away from itself in between, by more than this share. */
const AWAY = 0.6;
/** A shape that was drawn once is repeated for at least as many readings, and at least as often. */
const REPEATED = 4 * READS_A_SECOND;
const REPEATED_LAPS = 3;
/** Two hands keep one tempo when their laps differ by a smaller factor. */
const ONE_TEMPO = 1.15;
/** The way back to the beginning has at least as many readings. */
const WAY_BACK = 10;
/** The smallest drawing: its readings, and its extent. */
const FEWEST = 20;
const SMALLEST = 4;

/** The settings of a model of a drawing, chosen on thirty made drawings, judged on thirty others and on people's. */
export const DRAWING_SETTINGS = {
  latent: 2,
  dynamicsIps: 16,
  poseIps: 16,
  order: 2,
  seed: 0,
  maxIterations: 150,
};

/** The longest drawing, in seconds. */
export const LONGEST = 20;

/** The size of a pad: places are hundredths of its width, x to the right and y up. */
export const WIDTH = 100;
export const HEIGHT = 133;

/** A place of the pen on a pad, at a time in seconds. */
export interface Sample {
  seconds: number;
  x: number;
  y: number;
}

/** What was drawn on one pad, from each touch of the pen to its end. */
export type Strokes = readonly (readonly Sample[])[];

/** Places, [rows or readings][x and y of each pad]. */
export type Rows = readonly (readonly number[])[];

export interface Drawing {
  /** [rows][x and y of each pad] */
  rows: Rows;
  /** Rows a second: `ROWS_A_SECOND`, or half, a third, ... as many. */
  rate: number;
  /** About as many rows pass until the pens are where they began. */
  lap: number;
  /** Whether a shape was drawn once only, so that it is repeated. */
  once: boolean;
  /** All readings, `READS_A_SECOND`: the rows are some of them. */
  readings: Rows;
  /** One round of each pad without a seam, which can be played for ever: readings. */
  rounds: Rows[];
  /** By how much a hand was slowed down to the tempo of the other; null: the hands keep different tempos. */
  tempo: number | null;
}

const distance = (a: readonly number[], b: readonly number[]) =>
  Math.hypot(...a.map((value, i) => value - (b[i] ?? 0)));
/** The square of the distance of two places on one pad: a long drawing asks for it half a million times. */
const squared = ([x = 0, y = 0]: readonly number[], [a = 0, b = 0]: readonly number[]) =>
  (x - a) ** 2 + (y - b) ** 2;
const between = (a: readonly number[], b: readonly number[], share: number) =>
  a.map((value, i) => value + share * ((b[i] ?? 0) - value));

/** The path of the pen at even steps from `first` seconds on; between two strokes the pen glides. */
function evenly(strokes: Strokes, first: number, count: number): number[][] {
  const samples = strokes.flat();
  let next = 0;
  return Array.from({ length: count }, (_, row) => {
    const now = first + row / READS_A_SECOND;
    while (next < samples.length - 1 && (samples[next]?.seconds ?? 0) < now) next += 1;
    const [a, b] = [samples[Math.max(0, next - 1)], samples[next]];
    if (!a || !b) return [WIDTH / 2, HEIGHT / 2];
    const length = b.seconds - a.seconds;
    const share = length > 0 ? Math.min(1, Math.max(0, (now - a.seconds) / length)) : 1;
    return between([a.x, a.y], [b.x, b.y], share);
  });
}

/** A Gaussian mean over the neighbours of each row; `closed`: the last row is a neighbour of the first. */
function smoothed(rows: Rows, closed = false): number[][] {
  const reach = 3 * SMOOTH;
  const last = rows.length - 1;
  return rows.map((row, at) => {
    const sum = row.map(() => 0);
    let weights = 0;
    for (let k = -reach; k <= reach; k++) {
      const other = closed ? (at + k + rows.length) % rows.length : at + k;
      if (other < 0 || other > last) continue;
      const weight = Math.exp(-0.5 * (k / SMOOTH) ** 2);
      weights += weight;
      rows[other]?.forEach((value, i) => {
        sum[i] = (sum[i] ?? 0) + weight * value;
      });
    }
    return sum.map((value) => value / weights);
  });
}

/** Without rests at both ends, and with short ones within. */
function withoutRests(rows: number[][]): number[][] {
  const speeds = rows.map((row, i) => distance(row, rows[i + 1] ?? rows[i - 1] ?? row));
  const usual = [...speeds].sort((a, b) => a - b)[Math.floor(0.6 * speeds.length)] ?? 0;
  const moves = speeds.map((speed) => speed > REST * usual);
  const [first, last] = [moves.indexOf(true), moves.lastIndexOf(true)];
  let rested = 0;
  return rows.filter((_, i) => {
    if (i < first || i > last) return false;
    rested = moves[i] ? 0 : rested + 1;
    return rested <= LONGEST_REST;
  });
}

/** How many readings of one pad pass until the pen is again where it was; null: it does not return. */
export function lapOf(rows: Rows): number | null {
  const mean = (rows[0] ?? []).map((_, i) => rows.reduce((sum, row) => sum + (row[i] ?? 0), 0) / rows.length);
  const spread = rows.reduce((sum, row) => sum + squared(row, mean), 0) / rows.length;
  const unlike = (lag: number) => {
    const pairs = rows.length - lag;
    let sum = 0;
    for (let i = 0; i < pairs; i++) sum += squared(rows[i] ?? [], rows[i + lag] ?? []);
    return sum / pairs / (2 * spread);
  };
  const most = Math.floor(0.6 * rows.length);
  const all = Array.from({ length: most + 1 }, (_, lag) => unlike(lag));
  // A lap begins after the pen has been far away.
  const left = all.findIndex((value) => value > AWAY);
  if (left < 0) return null;
  for (let lag = left + 1; lag < most; lag++) {
    const now = all[lag] ?? 1;
    if (now < RETURNS && now <= Math.min(all[lag - 1] ?? 1, all[lag + 1] ?? 1)) return lag;
  }
  return null;
}

/** The way from the end of a drawing back to its beginning, at the usual speed. */
function wayBack(rows: Rows): number[][] {
  const [a, b] = [rows.at(-1) ?? [], rows[0] ?? []];
  const usual =
    rows.reduce((sum, row, i) => sum + (i ? distance(row, rows[i - 1] ?? row) : 0), 0) / rows.length;
  const count = Math.max(WAY_BACK, Math.round(distance(a, b) / usual));
  const out = a.map((value, i) => value - (rows.at(-4)?.[i] ?? value));
  const into = b.map((value, i) => (rows[3]?.[i] ?? value) - value);
  const reach = count / 3 / 3;
  return Array.from({ length: count - 1 }, (_, k) => {
    const t = (k + 1) / count;
    // A cubic Bézier curve with the directions of both ends.
    const [c0, c1, c2, c3] = [(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t * t, t ** 3];
    return a.map((value, i) => {
      const end = b[i] ?? 0;
      return (
        c0 * value + c1 * (value + reach * (out[i] ?? 0)) + c2 * (end - reach * (into[i] ?? 0)) + c3 * end
      );
    });
  });
}

/** One round without a seam: of a drawing that returns to itself, the lap in its middle. */
function closed(drawn: Rows, lap: number | null = null): number[][] {
  const first = lap === null ? 0 : (drawn.length - lap) >> 1;
  const rows = lap === null ? drawn : drawn.slice(first, first + lap - WAY_BACK + 1);
  return smoothed([...rows, ...wayBack(rows)], true);
}

const isOneTempo = (lap: number, other: number) => Math.max(lap / other, other / lap) < ONE_TEMPO;

/** The table that the model learns: every n-th reading, so that a lap of `lap` readings has at most `MOST_OF_LAP` rows. */
function tableOf(readings: Rows, lap: number) {
  const every = EVERY * Math.ceil(lap / (EVERY * MOST_OF_LAP));
  const rows = readings.filter((_, i) => i % every === 0);
  return { rows, rate: READS_A_SECOND / every, lap: Math.round(lap / every) };
}

/**
 * A drawing on one pad or on several, with the same clock; null: too little was drawn. A drawing that returns
 * to itself stays as it was drawn; another one gets a way back to its beginning and is repeated.
 */
export function drawingOf(pads: readonly Strokes[]): Drawing | null {
  const times = pads.map((strokes) => strokes.flat().map(({ seconds }) => seconds));
  const first = Math.max(...times.map((of) => of[0] ?? 0));
  const last = Math.min(...times.map((of) => of.at(-1) ?? 0));
  const count = Math.floor((last - first) * READS_A_SECOND) + 1;
  if (count < FEWEST) return null;
  const even = pads.map((strokes) => evenly(strokes, first, count));
  const joined = Array.from({ length: count }, (_, i) => even.flatMap((of) => of[i] ?? []));
  const drawn = withoutRests(smoothed(joined));
  const extent = (i: number) => {
    const values = drawn.map((row) => row[i] ?? 0);
    return Math.max(...values) - Math.min(...values);
  };
  if (drawn.length < FEWEST || Math.max(...(joined[0]?.map((_, i) => extent(i)) ?? [])) < SMALLEST)
    return null;
  const loop = closed(drawn);
  const laps = pads.map((_, pad) => lapOf(onPad(drawn, pad)));
  const known = laps.filter((lap) => lap !== null);
  const once = known.length < laps.length;
  const often = Math.max(REPEATED_LAPS, Math.ceil(REPEATED / loop.length));
  const readings = once ? Array.from({ length: often }, () => loop).flat() : drawn;
  const lap = once ? loop.length : Math.max(...known);
  const rounds = laps.map((own, pad) => (own === null ? onPad(loop, pad) : closed(onPad(drawn, pad), own)));
  const tempo = once || isOneTempo(lap, Math.min(...known)) ? 1 : null;
  return { ...tableOf(readings, lap), once, readings, rounds, tempo };
}

/** Readings as if the pen had been `factor` times as fast; after the last one comes the first. */
const paced = (rows: Rows, factor: number, count: number) =>
  Array.from({ length: count }, (_, i) => {
    const [whole, share] = [Math.floor(i * factor), (i * factor) % 1];
    return between(rows[whole % rows.length] ?? [], rows[(whole + 1) % rows.length] ?? [], share);
  });

/**
 * A drawing of two hands: `own` was drawn while a round of the other hand was played. When both tempos are near, it
 * gets the tempo of the other: else the hands would drift apart by accident, and there were no coupling to learn.
 * `place`: that of the drawn hand.
 */
export function drawnBeside(round: Rows, own: Drawing, place: number): Drawing {
  const [one = []] = own.rounds;
  const repeats = own.once || own.readings.length < 2 * round.length;
  const [rows, lap] = repeats ? [one, one.length] : [own.readings, lapOf(own.readings) ?? one.length];
  const isNear = isOneTempo(lap, round.length);
  const factor = isNear ? lap / round.length : 1;
  const slowest = Math.max(round.length, lap / factor);
  const count = repeats ? Math.max(REPEATED_LAPS * slowest, REPEATED) : (rows.length - 1) / factor;
  const readings = paced(rows, factor, Math.floor(count)).map((row, i) => {
    const other = round[i % round.length] ?? [];
    return place === 0 ? [...row, ...other] : [...other, ...row];
  });
  const rounds = [round, paced(one, factor, Math.round(one.length / factor))];
  if (place === 0) rounds.reverse();
  return { ...tableOf(readings, slowest), once: false, readings, rounds, tempo: isNear ? 1 / factor : null };
}

/** The rows of one pad. */
export const onPad = (rows: Rows, pad: number): number[][] =>
  rows.map((row) => row.slice(2 * pad, 2 * pad + 2));

/** Where the pen is when a round has been played for some seconds. */
export const placeInRound = (round: Rows, seconds: number): readonly number[] | null =>
  round[Math.round(seconds * READS_A_SECOND) % round.length] ?? null;
