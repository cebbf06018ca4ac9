// The findings of the figures as sentences.
import { modelStyle } from "../figures/model-style";
import { twoDecimals } from "../figures/numbers";
import type { Correlation, Growth, ModelSummary } from "../engine/whole-protocol";

/** "rank correlation −0.90 over 5 settings" */
export function rankWords({ rank, settings }: Correlation): string {
  const over = `over ${settings} ${settings === 1 ? "setting" : "settings"}`;
  return settings < 3 || !Number.isFinite(rank)
    ? `no rank correlation ${over}`
    : `rank correlation ${twoDecimals(rank)} ${over}`;
}

export function correlationFinding(correlation: Correlation): string {
  const { model, rank, settings } = correlation;
  const says =
    settings < 3 || !Number.isFinite(rank)
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
