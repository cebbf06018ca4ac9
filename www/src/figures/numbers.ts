// Numbers in figures and their tables, with their significant digits.
import { decimalsOf, fixed, grouped, localNumber, MOST_DECIMALS } from "../ui/format";
import { lab } from "../words/lab";

/** A mean and its standard error. */
export interface Estimate {
  mean: number;
  standardError: number | null;
  count: number;
}

/** The power of ten of a number's first digit. */
function magnitude(value: number): number {
  return value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)) + 1e-12);
}

function byPower(value: number, digits: number): string {
  const [factor, power] = value.toExponential(digits - 1).split("e") as [string, string];
  return `${localNumber(factor).replace("-", "\u2212")} × 10${superscript(Number(power))}`;
}

function superscript(power: number): string {
  return [...String(power)].map((sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)])).join("");
}

/** Three significant digits, all digits before the point. */
export function plain(value: number): string {
  if (!Number.isFinite(value)) return lab().files.figures.unknown;
  const size = magnitude(value);
  return size < -6 || size > 11
    ? byPower(value, 3)
    : grouped(value, Math.min(MOST_DECIMALS, Math.max(0, 2 - size)));
}

/** A mean and its standard error, with the digits that are significant under the error. */
export function estimateText({ mean, standardError, count }: Estimate): { mean: string; error: string } {
  if (!Number.isFinite(mean) || count === 0) return { mean: lab().files.figures.unknown, error: "" };
  if (standardError === null || !Number.isFinite(standardError))
    return { mean: plain(mean), error: count === 1 ? lab().files.figures.oneTrial : "" };
  if (standardError === 0) return { mean: plain(mean), error: "± 0" };
  const decimals = 1 - magnitude(Number(standardError.toPrecision(2)));
  if (decimals > 9) return { mean: plain(mean), error: `± ${byPower(standardError, 2)}` };
  return {
    mean: grouped(mean, Math.max(0, decimals)),
    error: `± ${grouped(standardError, Math.max(0, decimals))}`,
  };
}

/** Labels of values with equal steps, all with the same number of decimals. */
export function evenLabels(values: readonly number[]): { value: number; label: string }[] {
  const decimals = decimalsOf(values);
  return values.map((value) => ({ value, label: tickLabel(value, decimals) }));
}

/** Labels of values on a logarithmic scale: each with its own decimals. */
export function powerLabels(values: readonly number[]): { value: number; label: string }[] {
  return values.map((value) => ({ value, label: tickLabel(value, decimalsOf([value])) }));
}

function tickLabel(value: number, decimals: number): string {
  const size = magnitude(value);
  if (value !== 0 && (size < -6 || size > 6)) {
    const digits = String(Number(value.toExponential().split("e")[0])).replace(/[-.]/g, "").length;
    const text = byPower(value, digits);
    return text.replace(/^1 × /, "");
  }
  return grouped(value, decimals);
}

/** A ratio of two numbers. */
export function ratio(value: number): string {
  return value >= 100 ? grouped(value) : value >= 10 ? fixed(value, 1) : fixed(value, 2);
}

/** A share as "99.2 %". The explained share of a fit may be negative. */
export function percent(share: number): string {
  return `${grouped(100 * share, 1)} %`;
}

/** A rank correlation or an exponent. */
export function twoDecimals(value: number): string {
  return Number.isFinite(value) ? grouped(value, 2) : lab().files.figures.unknown;
}
