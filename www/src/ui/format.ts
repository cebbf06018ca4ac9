// Formats numbers and texts for the page, in its language.
import { decimal, withComma } from "./decimal";
import { languageChanges } from "./language";

/** The text of a number in the language of the page. */
export const localNumber = (number: string): string =>
  languageChanges.language === "de" ? withComma(number) : number;

/** A number with this many decimals. */
export const fixed = (value: number, decimals: number): string => localNumber(value.toFixed(decimals));

/** Three significant digits, without an exponent between 0.001 and 10,000. */
export function short(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e4 || size < 1e-3) return localNumber(value.toExponential(1).replace("e+", "e"));
  return localNumber(size >= 100 ? value.toFixed(0) : size >= 10 ? value.toFixed(1) : value.toPrecision(2));
}

/** A weight between 0 and 1. */
export function weight(value: number): string {
  return localNumber(value > 0 && value < 0.005 ? "<0.01" : value.toFixed(2));
}

/** All digits before the point in groups of three, and `decimals` after it. */
export function grouped(value: number, decimals = 0): string {
  const text = decimal(languageChanges.language, value, decimals);
  return /^-[0.,]+$/.test(text) ? text.slice(1) : text.replace("-", "\u2212");
}

/** The most decimals on the page. */
export const MOST_DECIMALS = 8;

/** The decimals that write each of these numbers exactly. */
export function decimalsOf(values: readonly number[]): number {
  const own = (value: number) =>
    String(value).includes("e") ? MOST_DECIMALS : (String(value).split(".")[1]?.length ?? 0);
  return Math.min(MOST_DECIMALS, Math.max(0, ...values.map(own)));
}

/** "3 s", "1 min 20 s", "2 min", "2 h 5 min" */
export function duration(seconds: number): string {
  const whole = Math.round(seconds);
  if (whole >= 3600) return `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
  if (whole < 60) return `${whole} s`;
  const minutes = `${Math.floor(whole / 60)} min`;
  return whole % 60 === 0 ? minutes : `${minutes} ${whole % 60} s`;
}

/** A clip's name without its file extension. */
export function clipTitle(name: string): string {
  return name.replace(/\.bvh$/i, "");
}

/** A text with a capital letter and a full stop. */
export function sentence(words: string): string {
  const text = words.trim();
  if (text === "") return "";
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? "" : "."}`;
}

/** The message of a caught error. */
export function messageOf(problem: unknown): string {
  return problem instanceof Error ? problem.message : String(problem);
}
