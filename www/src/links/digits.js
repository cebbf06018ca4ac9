// A document with fewer digits, for the page's own files and for links. Plain JavaScript, because the build
// script runs it in Node too.

/**
 * Seven digits halve the file and change the position of a joint by less than a twentieth of a millimetre in
 * ten seconds.
 */
const DIGITS = 7;

/** A number with fewer digits; other values stay. */
export const rounded = (/** @type {unknown} */ value, digits = DIGITS) =>
  typeof value === "number" && !Number.isInteger(value) ? Number(value.toPrecision(digits)) : value;

/**
 * A document with fewer digits. Shortened again it is the same.
 * @param {any} value
 * @param {Readonly<Record<string, number>>} digitsOf the digits of the fields with these names
 * @returns {any}
 */
export function shortened(value, digitsOf, digits = DIGITS) {
  if (Array.isArray(value)) return value.map((entry) => shortened(entry, digitsOf, digits));
  if (value === null || typeof value !== "object") return rounded(value, digits);
  const entries = Object.entries(value).map(([name, entry]) => [
    name,
    shortened(entry, digitsOf, digitsOf[name] ?? digits),
  ]);
  return Object.fromEntries(entries);
}
