// The part of a bound's course that is worth drawing, and the numbers beside it.
import { decimalsOf, grouped } from "../ui/format";

/** So many values are enough to know where most of them lie. */
const ENOUGH = 3000;

/**
 * The range to draw: the first iterations come from far below and would flatten the rest. Where a run has not
 * been there is null.
 */
export function boundRange(values: readonly (number | null)[]): [number, number] {
  const every = Math.ceil(values.length / ENOUGH);
  const finite = values.filter(
    (value, i): value is number => Number.isFinite(value) && (values.length - 1 - i) % every === 0,
  );
  if (finite.length === 0) return [0, 1];
  const sorted = [...finite].sort((a, b) => a - b);
  const top = sorted.at(-1) ?? 0;
  const low = sorted[Math.floor(sorted.length * (sorted.length > 30 ? 0.12 : 0))] ?? top;
  const pad = Math.max(1, 0.08 * (top - low));
  return [low - pad, top + pad];
}

/** The numbers beside a chart's lines, all with as many decimals as one of them needs. */
export function axisNumbers(ticks: readonly number[]): string[] {
  const decimals = decimalsOf(ticks);
  return ticks.map((tick) => grouped(tick, decimals));
}
