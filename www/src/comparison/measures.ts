// The measures in the table of models.
import { linearScale, logScale, type Scale } from "../figures/scale";
import type { ModelSummary, Spread } from "../engine/whole-protocol";

/** Free pixels at the ends of a scale, for whole marks. */
const EDGE = 6;

export interface Measure {
  name: "error" | "bound" | "training" | "size";
  /** The value of a model; null: the model has none. */
  spread(summary: ModelSummary): Spread | null;
  scale: "linear" | "log";
  best: "least" | "greatest";
}

export const MEASURES: Measure[] = [
  { name: "error", spread: ({ mse }) => mse, scale: "log", best: "least" },
  { name: "bound", spread: ({ bound }) => bound, scale: "linear", best: "greatest" },
  { name: "training", spread: ({ seconds }) => seconds, scale: "log", best: "least" },
  { name: "size", spread: ({ storedNumbers }) => storedNumbers, scale: "log", best: "least" },
];

/** The ends of an error bar. */
export function ends({ mean, standardError }: Spread): [number, number] {
  const error = standardError ?? 0;
  return [mean - error, mean + error];
}

/**
 * The most that an error bar below a mean stretches a log scale; one near zero would fill the whole scale.
 */
const BELOW = 5;

/** The scale of a drawing: all means with error bars, and for the error also that of a prediction at rest. */
export function scaleOf(measure: Measure, models: readonly ModelSummary[], width: number): Scale {
  const values = models.flatMap((summary) => {
    const spread = measure.spread(summary);
    if (!spread) return [];
    const [low, high] = ends(spread);
    const reference = measure.name === "error" ? [summary.variance] : [];
    return [
      spread.mean,
      measure.scale === "log" ? Math.max(low, spread.mean / BELOW) : low,
      high,
      ...reference,
    ];
  });
  return (measure.scale === "log" ? logScale : linearScale)(values, EDGE, width - EDGE);
}

/** Whether two means differ by more than their standard errors together. A single trial decides nothing. */
export function differs(a: Spread, b: Spread): boolean {
  return Math.abs(a.mean - b.mean) > (a.standardError ?? Infinity) + (b.standardError ?? Infinity);
}

/** The spreads of a measure, the best first. */
function ranked(measure: Measure, models: readonly ModelSummary[]): Spread[] {
  const spreads = models.flatMap((summary) => measure.spread(summary) ?? []);
  const sign = measure.best === "least" ? 1 : -1;
  return spreads.filter(({ mean }) => Number.isFinite(mean)).sort((a, b) => sign * (a.mean - b.mean));
}

/** The best mean; null with fewer than two, or if the next one does not differ. */
export function bestOf(measure: Measure, models: readonly ModelSummary[]): number | null {
  const [first, second] = ranked(measure, models);
  return first && second && differs(first, second) ? first.mean : null;
}

/** Whether a few trials make most of the error; the median then says more than the mean. */
export function isSkewed({ mse, mseMedian }: ModelSummary): boolean {
  return mseMedian > 0 && mse.mean > 1.5 * mseMedian;
}
