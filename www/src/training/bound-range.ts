// The range of bounds that the chart draws, and the numbers of its axis.
/** Enough values for the quantiles. */
const ENOUGH = 3000;

/** The range to draw. The first iterations lie far below and would flatten the rest. */
export function boundRange(values: readonly number[]): [number, number] {
  const every = Math.ceil(values.length / ENOUGH);
  const finite = values.filter((value, i) => Number.isFinite(value) && (values.length - 1 - i) % every === 0);
  if (finite.length === 0) return [0, 1];
  const sorted = [...finite].sort((a, b) => a - b);
  const top = sorted.at(-1) ?? 0;
  const low = sorted[Math.floor(sorted.length * (sorted.length > 30 ? 0.12 : 0))] ?? top;
  const pad = Math.max(1, 0.08 * (top - low));
  return [low - pad, top + pad];
}
