// The range of bounds that the chart draws, and the numbers of its axis.
import { decimalsOf, grouped } from "../ui/format";

/** Enough values for the quantiles. */
const ENOUGH = 3000;

/** The range to draw. The first iterations lie far below and would flatten the rest. Null: no value. */
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

/** The numbers of an axis, all with as many decimals as one of them needs. */
export function axisNumbers(ticks: readonly number[]): string[] {
  const decimals = decimalsOf(ticks);
  return ticks.map((tick) => grouped(tick, decimals));
}
