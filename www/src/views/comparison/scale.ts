// From values to places on the page, and the values that an axis names.
import { evenLabels, powerLabels } from "./numbers";

export interface Tick {
  value: number;
  label: string;
}

export interface Scale {
  kind: "linear" | "log";
  low: number;
  high: number;
  /** The place of a value; one that the scale does not reach lies at its end. */
  at(value: number): number;
  /** At most `most` of them, ascending; at least two, unless the axis has room for fewer. */
  ticks(most: number): Tick[];
}

/** How much of an axis stays free beyond the outermost values, a side. */
const MARGIN = 0.06;

/** The outermost of the values that a logarithm, or anything, can be taken of. */
function extent(values: readonly number[], least: number): [number, number] | null {
  const drawn = values.filter((value) => Number.isFinite(value) && value > least);
  return drawn.length === 0 ? null : [Math.min(...drawn), Math.max(...drawn)];
}

function placed(value: number, low: number, high: number, from: number, to: number): number {
  return from + (to - from) * Math.min(1, Math.max(0, (value - low) / (high - low)));
}

/** Round steps: 1, 2 or 5 times a power of ten. */
function stepFor(room: number, most: number): number {
  const power = 10 ** Math.floor(Math.log10(room / most));
  return power * (([1, 2, 5].find((times) => times * power >= room / most) ?? 10));
}

function evenly(low: number, high: number, most: number): number[] {
  let step = stepFor(high - low, most);
  // A step that fits may still meet the axis once more than there is room for.
  const count = () => Math.floor(high / step) - Math.ceil(low / step) + 1;
  if (count() > most) step = stepFor(step * most * 1.01, most);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.max(0, count()) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Powers of ten with what is between them, as dense as there is room for. */
function byPowers(low: number, high: number, most: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const dense = (times: readonly number[], every: number) => {
    const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i).filter((power) => power % every === 0);
    return powers.flatMap((power) => times.map((of) => Number(`${of}e${power}`))).filter((value) => value >= low && value <= high);
  };
  const choices = [dense([1, 2, 5], 1), dense([1, 3], 1), ...[1, 2, 3, 4, 6].map((every) => dense([1], every))];
  return choices.find((values) => values.length <= most) ?? [];
}

export function linearScale(values: readonly number[], from: number, to: number): Scale {
  const [least, greatest] = extent(values, -Infinity) ?? [0, 1];
  const room = greatest - least || Math.abs(least) || 1;
  const [low, high] = [least - MARGIN * room, greatest + MARGIN * room];
  return {
    kind: "linear", low, high,
    at: (value) => placed(value, low, high, from, to),
    ticks: (most) => evenLabels(evenly(low, high, Math.max(1, most))),
  };
}

/** Of positive values; others lie at its lower end. */
export function logScale(values: readonly number[], from: number, to: number): Scale {
  const [least, greatest] = extent(values, 0) ?? [1, 10];
  // Values that are nearly the same keep some room around them.
  const beyond = Math.max(MARGIN * Math.log(greatest / least), Math.log(1.1));
  const [low, high] = [least * Math.exp(-beyond), greatest * Math.exp(beyond)];
  const [logLow, logHigh] = [Math.log(low), Math.log(high)];
  return {
    kind: "log", low, high,
    at: (value) => placed(value > 0 ? Math.log(value) : -Infinity, logLow, logHigh, from, to),
    ticks: (most) => {
      const powers = byPowers(low, high, Math.max(1, most));
      return powers.length > 1 ? powerLabels(powers) : evenLabels(evenly(low, high, Math.max(1, most)));
    },
  };
}
