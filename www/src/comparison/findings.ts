// The findings of the figures as sentences.
import { modelStyle } from "../figures/model-style";
import { twoDecimals } from "../figures/numbers";
import { differs } from "./measures";
import type { Correlation, Growth, ModelSummary } from "../engine/whole-protocol";

/** Of fewer settings, even a perfect order is likely by chance: 1 in 12 for four settings. */
const FEWEST_SETTINGS = 5;

/** "rank correlation −0.90 over 5 settings" */
export function rankWords({ rank, settings }: Correlation): string {
  const over = `over ${settings} ${settings === 1 ? "setting" : "settings"}`;
  return settings < FEWEST_SETTINGS || !Number.isFinite(rank)
    ? `no rank correlation ${over}`
    : `rank correlation ${twoDecimals(rank)} ${over}`;
}

export function correlationFinding(correlation: Correlation): string {
  const { model, rank, settings } = correlation;
  const says =
    settings < FEWEST_SETTINGS || !Number.isFinite(rank)
      ? "too few settings to say more"
      : rank <= -0.5
        ? "a higher bound goes with a smaller error"
        : rank >= 0.5
          ? "a higher bound goes with a larger error"
          : "the bound says little about the error";
  return `${modelStyle(model).name}, error against bound: ${rankWords(correlation)}; ${says}.`;
}

/** "exponent 1.03" */
export function exponentWords({ exponent }: Growth): string {
  return exponent === null || !Number.isFinite(exponent)
    ? "no exponent"
    : `exponent ${twoDecimals(exponent)}`;
}

export function growthFinding(growth: readonly Growth[]): string {
  return `Seconds an iteration against frames, both on log scales: ${growth.map((line) => `${modelStyle(line.model).name}, ${exponentWords(line)}`).join("; ")}.`;
}

/** The number of trials of the means. */
export function foldWords(models: readonly ModelSummary[]): string {
  const folds = models.map((summary) => summary.folds);
  const [least, most] = [Math.min(...folds), Math.max(...folds)];
  if (most === 1)
    return "One trial was held out and predicted; how it would be with others is not known yet.";
  return `Mean ± standard error over ${least === most ? most : `${least} to ${most}`} trials, each held out in turn and predicted; the bars are the standard errors.`;
}

/** Which model has the lowest error here, whether that is decided, and where the vCGPDM is. */
export function errorFinding(models: readonly ModelSummary[]): string {
  const ranked = models
    .filter(({ mse }) => Number.isFinite(mse.mean))
    .sort((a, b) => a.mse.mean - b.mse.mean);
  const [first, second] = ranked;
  if (!first || !second) return "";
  const name = ({ model, label }: ModelSummary) => [modelStyle(model).name, label].filter(Boolean).join(", ");
  const lowest = differs(first.mse, second.mse)
    ? `${name(first)} has the lowest error here.`
    : `Which model has the lowest error here is undecided: ${name(first)} and ${name(second)} differ by less than their standard errors together.`;
  const own = ranked.find(({ model }) => model === "vcgpdm");
  if (!own || own === first) return lowest;
  const ratio = twoDecimals(own.mse.mean / first.mse.mean);
  return `${lowest} The error of the vCGPDM is ${ratio} times the lowest${differs(own.mse, first.mse) ? "" : ", which is undecided too"}.`;
}
