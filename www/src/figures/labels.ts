// Where labels go so that they can be read.

/**
 * Places in the order of the wanted ones, at least `gap` apart and within [low, high], as near to the wanted
 * ones as that allows (least squares). Too many for the room lie evenly over it.
 */
export function spreadLabels(wanted: readonly number[], gap: number, low: number, high: number): number[] {
  const steps = Math.max(1, wanted.length - 1);
  const step = Math.min(gap, (high - low) / steps);
  const ascending = wanted.map((place, index) => ({ place, index })).sort((a, b) => a.place - b.place);
  // With i steps taken off the i-th, what is left only has to ascend: neighbours that do not are pooled at
  // their mean.
  const pools: { sum: number; count: number }[] = [];
  const mean = ({ sum, count }: { sum: number; count: number }) => sum / count;
  ascending.forEach(({ place }, rank) => {
    let pool = { sum: place - rank * step, count: 1 };
    for (let before = pools.at(-1); before && mean(before) > mean(pool); before = pools.at(-1)) {
      pool = { sum: before.sum + pool.sum, count: before.count + pool.count };
      pools.pop();
    }
    pools.push(pool);
  });
  const most = high - (wanted.length - 1) * step;
  const starts = pools.flatMap((pool) =>
    new Array<number>(pool.count).fill(Math.min(Math.max(mean(pool), low), most)),
  );
  const places = new Array<number>(wanted.length).fill(low);
  ascending.forEach(({ index }, rank) => {
    places[index] = (starts[rank] ?? low) + rank * step;
  });
  return places;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Point {
  x: number;
  y: number;
}

function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

/** How often all labels are placed anew, now that they know where the others went. */
const ROUNDS = 4;
/** How near a label comes to the mark of another point before it could be taken for its label. */
const CLEAR = 4;

/** A label may lie so many square pixels over something else, by rounding. */
const TOUCH = 2;

/**
 * A box for the label of each point, placeLabels it where nothing else is; null where there is no such place.
 * `reach` is a mark's half width.
 */
export function placeLabels(
  points: readonly Point[],
  widths: readonly number[],
  height: number,
  reach: number,
  within: Box,
): (Box | null)[] {
  const around = reach + CLEAR;
  const marks = points.map(({ x, y }) => ({
    x: x - around,
    y: y - around,
    width: 2 * around,
    height: 2 * around,
  }));
  const choices = points.map(({ x, y }, i) => {
    const width = widths[i] ?? 0;
    const [right, left] = [x + reach + 3, x - reach - 3 - width];
    const [above, middle, below] = [y - reach - height, y - height / 2, y + reach];
    const corners: [number, number][] = [
      [right, middle],
      [left, middle],
      [x - width / 2, above],
      [x - width / 2, below],
      [right, above],
      [right, below],
      [left, above],
      [left, below],
    ];
    return corners.map(([bx, by]): Box => ({ x: bx, y: by, width, height }));
  });
  const placed = choices.flatMap((boxes) => boxes.slice(0, 1));
  for (let round = 0; round < ROUNDS; round++) {
    choices.forEach((boxes, i) => {
      const others = [...marks, ...placed].filter((_, other) => other % points.length !== i);
      const cost = (box: Box) =>
        4 * (box.width * box.height - overlap(box, within)) +
        others.reduce((sum, other) => sum + overlap(box, other), 0);
      // Less by a pixel: rounding is no reason to leave the first choice.
      placed[i] = boxes.reduce((best, box) => (cost(box) < cost(best) - 1 ? box : best));
    });
  }
  return withoutCollisions(placed, marks, within);
}

/** Of labels that lie on each other, on the mark of another point or beyond the room only the first stays. */
function withoutCollisions(placed: readonly Box[], marks: readonly Box[], within: Box): (Box | null)[] {
  const kept: (Box | null)[] = [];
  placed.forEach((box, i) => {
    const others = [...kept, ...marks.filter((_, other) => other !== i)];
    const isFree = others.every((other) => other === null || overlap(box, other) <= TOUCH);
    kept.push(isFree && box.width * box.height - overlap(box, within) <= TOUCH ? box : null);
  });
  return kept;
}

/** Labels in short, and what was taken off them because it does not tell them apart. */
export interface ShortLabels {
  short: string[];
  /** What the numbers that are left count: "inducing points". */
  units: string;
  /** What holds for all: "order 2". */
  all: string;
}

/**
 * Labels are clauses: "4 + 4 inducing points, 800 iterations". A clause that all have says nothing, and of
 * one in which they differ the words that all end in are its unit: "4 + 4" is left.
 */
export function shortenLabels(labels: readonly string[]): ShortLabels {
  const clauses = labels.map((label) => label.split(", "));
  const [first = []] = clauses;
  const unchanged = { short: [...labels], units: "", all: "" };
  if (new Set(labels).size < 2 || clauses.some(({ length }) => length !== first.length)) return unchanged;
  const columns = first.map((_, place) => clauses.map((label) => label[place] ?? ""));
  const varying = columns.filter((column) => new Set(column).size > 1).map(withoutUnit);
  const same = columns.filter((column) => new Set(column).size === 1);
  return {
    short: labels.map((_, i) => varying.map(({ short }) => short[i]).join(", ")),
    units: varying
      .map(({ unit }) => unit)
      .filter(Boolean)
      .join(", "),
    all: same.map(([clause]) => clause).join(", "),
  };
}

/** Takes off the words without digits that all end in. */
function withoutUnit(clauses: readonly string[]): { short: string[]; unit: string } {
  const words = clauses.map((clause) => clause.split(" "));
  const [first = []] = words;
  const most = Math.min(...words.map(({ length }) => length)) - 1;
  let common = 0;
  const isShared = (word: string) =>
    /^\p{L}/u.test(word) && words.every((own) => own.at(-1 - common) === word);
  while (common < most && isShared(first.at(-1 - common) ?? "")) common++;
  return {
    short: words.map((own) => own.slice(0, own.length - common).join(" ")),
    unit: first.slice(first.length - common).join(" "),
  };
}
