// The places of values on the page, and the labelled values of an axis.
import { evenLabels, powerLabels } from "./numbers";

export interface Tick {
  value: number;
  label: string;
}

export interface Scale {
  kind: "linear" | "log";
  low: number;
  high: number;
  /** The place of a value. A value outside the scale is at its end. */
  at(value: number): number;
  /** At most `most` ticks, ascending; at least two, unless `most` is less. */
  ticks(most: number): Tick[];
}

/** The free space at each end, as a share of the range of the values. */
const MARGIN = 0.06;

/** The least and greatest finite value above `least`. */
function extent(values: readonly number[], least: number): [number, number] | null {
  const drawn = values.filter((value) => Number.isFinite(value) && value > least);
  return drawn.length === 0 ? null : [Math.min(...drawn), Math.max(...drawn)];
}

function placed(value: number, low: number, high: number, from: number, to: number): number {
  return from + (to - from) * Math.min(1, Math.max(0, (value - low) / (high - low)));
}

/** Multiples of the smallest round step (1, 2 or 5 times a power of ten) with at most `most` ticks. */
function evenly(low: number, high: number, most: number): number[] {
  const fine = Math.floor(Math.log10((high - low) / most)) - 1;
  const steps = Array.from({ length: 4 }, (_, i) =>
    [1, 2, 5].map((times) => Number(`${times}e${fine + i}`)),
  ).flat();
  const multiples = (step: number) => {
    const first = Math.ceil(low / step);
    return Array.from({ length: Math.max(0, Math.floor(high / step) - first + 1) }, (_, i) =>
      Number(((first + i) * step).toPrecision(12)),
    );
  };
  return steps.map(multiples).find(({ length }) => length <= most) ?? [];
}

/** Powers of ten and round values between them, at most `most`. */
function byPowers(low: number, high: number, most: number): number[] {
  const [first, last] = [Math.floor(Math.log10(low)), Math.floor(Math.log10(high))];
  const dense = (times: readonly number[], every: number) => {
    const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i);
    const values = powers
      .flatMap((power) => times.map((factor) => Number(`${factor}e${power}`)))
      .filter((value) => value >= low && value <= high);
    return values.filter((_, i) => i % every === 0);
  };
  const fewest = Math.ceil((last - first + 1) / most);
  const choices = [
    dense([1, 2, 5], 1),
    dense([1, 3], 1),
    ...[1, 2, 3, 4, 6, fewest].map((every) => dense([1], every)),
  ];
  return choices.find((values) => values.length <= most) ?? [];
}

export function linearScale(values: readonly number[], from: number, to: number): Scale {
  const [least, greatest] = extent(values, -Infinity) ?? [0, 1];
  const range = greatest - least || Math.abs(least) || 1;
  const [low, high] = [least - MARGIN * range, greatest + MARGIN * range];
  return {
    kind: "linear",
    low,
    high,
    at: (value) => placed(value, low, high, from, to),
    ticks: (most) => evenLabels(evenly(low, high, Math.max(1, most))),
  };
}

/** For positive values; other values are at the lower end. */
export function logScale(values: readonly number[], from: number, to: number): Scale {
  const [least, greatest] = extent(values, 0) ?? [1, 10];
  // Nearly equal values need some space around them.
  const beyond = Math.max(MARGIN * Math.log(greatest / least), Math.log(1.1));
  // A value of 1e300 must not make the scale infinite.
  const [low, high] = [
    Math.max(Number.MIN_VALUE, least * Math.exp(-beyond)),
    Math.min(Number.MAX_VALUE, greatest * Math.exp(beyond)),
  ];
  const [logLow, logHigh] = [Math.log(low), Math.log(high)];
  return {
    kind: "log",
    low,
    high,
    at: (value) => placed(value > 0 ? Math.log(value) : -Infinity, logLow, logHigh, from, to),
    ticks: (most) => {
      const powers = byPowers(low, high, Math.max(1, most));
      return powers.length > 1 ? powerLabels(powers) : evenLabels(evenly(low, high, Math.max(1, most)));
    },
  };
}
