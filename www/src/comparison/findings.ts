// The findings of the figures as sentences.
import { modelStyle } from "../figures/model-style";
import { twoDecimals } from "../figures/numbers";
import { differs } from "./measures";
import type { Correlation, Growth, ModelSummary } from "../engine/whole-protocol";
import { compareWords } from "./view-words";

/** Of fewer settings, even a perfect order is likely by chance: 1 in 12 for four settings. */
const FEWEST_SETTINGS = 5;

/** "rank correlation −0.90 over 5 settings" */
export function rankWords({ rank, settings }: Correlation): string {
  const known = settings >= FEWEST_SETTINGS && Number.isFinite(rank);
  return compareWords().correlation.rank(known ? twoDecimals(rank) : null, settings);
}

export function correlationFinding(correlation: Correlation): string {
  const { model, rank, settings } = correlation;
  const words = compareWords().correlation;
  const says =
    settings < FEWEST_SETTINGS || !Number.isFinite(rank)
      ? words.tooFew
      : rank <= -0.5
        ? words.smaller
        : rank >= 0.5
          ? words.larger
          : words.little;
  return words.finding(modelStyle(model).name, rankWords(correlation), says);
}

/** "exponent 1.03" */
export function exponentWords({ exponent }: Growth): string {
  const known = exponent !== null && Number.isFinite(exponent);
  return compareWords().growth.exponent(known ? twoDecimals(exponent) : null);
}

export function growthFinding(growth: readonly Growth[]): string {
  const lines = growth.map((line) => `${modelStyle(line.model).name}, ${exponentWords(line)}`);
  return compareWords().growth.finding(lines.join("; "));
}

/** The number of trials of the means. */
export function foldWords(models: readonly ModelSummary[]): string {
  const folds = models.map((summary) => summary.folds);
  const [least, most] = [Math.min(...folds), Math.max(...folds)];
  const { oneTrial, trials } = compareWords().finding;
  return most === 1 ? oneTrial : trials(least, most);
}

/** Which model has the lowest error here, whether that is decided, and where the vCGPDM is. */
export function errorFinding(models: readonly ModelSummary[]): string {
  const ranked = models
    .filter(({ mse }) => Number.isFinite(mse.mean))
    .sort((a, b) => a.mse.mean - b.mse.mean);
  const [first, second] = ranked;
  if (!first || !second) return "";
  const name = ({ model, label }: ModelSummary) => [modelStyle(model).name, label].filter(Boolean).join(", ");
  const words = compareWords().finding;
  const lowest = differs(first.mse, second.mse)
    ? words.lowest(name(first))
    : words.undecided(name(first), name(second));
  const own = ranked.find(({ model }) => model === "vcgpdm");
  if (!own || own === first) return lowest;
  const ratio = twoDecimals(own.mse.mean / first.mse.mean);
  return `${lowest}${words.own(ratio, differs(own.mse, first.mse))}`;
}
