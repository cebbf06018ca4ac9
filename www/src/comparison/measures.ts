// What the table of models compares.
import { linearScale, logScale, type Scale } from "../figures/scale";
import type { ModelSummary, Spread } from "../engine/whole-protocol";

/** Pixels kept free at the ends of a scale, so that marks there are whole. */
const EDGE = 6;

export interface Measure {
  title: string;
  unit: string;
  /** Its value of a model; null where the model has none. */
  spread(summary: ModelSummary): Spread | null;
  scale: "linear" | "log";
  best: "least" | "greatest";
  /** What the best is called. */
  word: string;
}

export const MEASURES: Measure[] = [
  { title: "Error", unit: "DTW MSE", spread: ({ mse }) => mse, scale: "log", best: "least", word: "best" },
  {
    title: "Bound",
    unit: "nats",
    spread: ({ bound }) => bound,
    scale: "linear",
    best: "greatest",
    word: "highest",
  },
  {
    title: "Training",
    unit: "seconds",
    spread: ({ seconds }) => seconds,
    scale: "log",
    best: "least",
    word: "quickest",
  },
  {
    title: "Size",
    unit: "numbers stored",
    spread: ({ storedNumbers }) => storedNumbers,
    scale: "log",
    best: "least",
    word: "fewest",
  },
];

/** The ends of an error bar. */
export function ends({ mean, standardError }: Spread): [number, number] {
  const error = standardError ?? 0;
  return [mean - error, mean + error];
}

/**
 * How far below a mean an error bar may stretch a log scale: one that nearly reaches zero would leave no room
 * for anything else.
 */
const BELOW = 5;

/**
 * For a drawing of a width: all means with their error bars, and for the error what a prediction that does
 * not move has.
 */
export function scaleOf(measure: Measure, models: readonly ModelSummary[], width: number): Scale {
  const values = models.flatMap((summary) => {
    const spread = measure.spread(summary);
    if (!spread) return [];
    const [low, high] = ends(spread);
    const reference = measure.unit === "DTW MSE" ? [summary.variance] : [];
    return [
      spread.mean,
      measure.scale === "log" ? Math.max(low, spread.mean / BELOW) : low,
      high,
      ...reference,
    ];
  });
  return (measure.scale === "log" ? logScale : linearScale)(values, EDGE, width - EDGE);
}

/** The best mean; null where fewer than two can be compared. */
export function bestOf(measure: Measure, models: readonly ModelSummary[]): number | null {
  const means = models.map((summary) => measure.spread(summary)?.mean ?? NaN).filter(Number.isFinite);
  if (means.length < 2) return null;
  return measure.best === "least" ? Math.min(...means) : Math.max(...means);
}

/**
 * Whether a few trials make most of the error, such as a rollout that goes astray: then the median says more
 * than the mean.
 */
export function isSkewed({ mse, mseMedian }: ModelSummary): boolean {
  return mseMedian > 0 && mse.mean > 1.5 * mseMedian;
}
