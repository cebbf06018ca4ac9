// The places of labels, without overlap.

let measure: CanvasRenderingContext2D | null = null;

/** The width in the page's font, pixels; an estimate without a page. */
export function textWidth(text: string, size: number, weight = 400): number {
  if (typeof document === "undefined") return 0.59 * size * text.length;
  measure ??= document.createElement("canvas").getContext("2d");
  if (!measure) return 0.68 * size * text.length;
  measure.font = `${weight} ${size}px ${getComputedStyle(document.documentElement).fontFamily}`;
  return measure.measureText(text).width;
}

/**
 * Places within [low, high], in the same order and at least `gap` apart, with the least squared distance from
 * the wanted places. If they do not fit, their distances are equal and smaller.
 */
export function spreadLabels(wanted: readonly number[], gap: number, low: number, high: number): number[] {
  const steps = Math.max(1, wanted.length - 1);
  const step = Math.min(gap, (high - low) / steps);
  const ascending = wanted.map((place, index) => ({ place, index })).sort((a, b) => a.place - b.place);
  // After i steps are subtracted from place i, the rest must only ascend: isotonic regression by pooling.
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

/** Number of passes over all labels. */
const ROUNDS = 4;
/** Least distance of a label from the mark of another point, pixels. */
const CLEAR = 4;

/** Square pixels of overlap that rounding can cause. */
const TOUCH = 2;

/**
 * A free box for the label of each point, next to its mark; null without one. `reach`: half width of a mark.
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
      // A difference below one square pixel is rounding.
      placed[i] = boxes.reduce((best, box) => (cost(box) < cost(best) - 1 ? box : best));
    });
  }
  return withoutCollisions(placed, marks, within);
}

/** Drops labels that overlap an earlier label or the mark of another point, or leave the space. */
function withoutCollisions(placed: readonly Box[], marks: readonly Box[], within: Box): (Box | null)[] {
  const free: (Box | null)[] = [];
  placed.forEach((box, i) => {
    const others = [...free, ...marks.filter((_, other) => other !== i)];
    const isFree = others.every((other) => other === null || overlap(box, other) <= TOUCH);
    free.push(isFree && box.width * box.height - overlap(box, within) <= TOUCH ? box : null);
  });
  return free;
}

/** Short labels, and the words that all labels had in common. */
export interface ShortLabels {
  short: string[];
  /** The unit of the remaining numbers: "inducing points". */
  units: string;
  /** The clauses that all labels have: "order 2". */
  all: string;
}

/**
 * Shortens labels such as "4 + 4 inducing points, 800 iterations". Clauses that all labels have are removed.
 * The last words that a clause has in all labels are its unit and are removed too, which leaves "4 + 4".
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

/** Removes the last words, without digits, that all clauses have. */
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
