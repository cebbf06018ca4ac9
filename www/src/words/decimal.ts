// Numbers in the sentences of a language.

/** A number with this many digits after the decimal point, as a language writes it. */
export function decimal(language: string, value: number, digits: number): string {
  const rounding = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return value.toLocaleString(language, rounding);
}

/** A number with a decimal point, written with the comma of German. */
export const withComma = (number: string): string => number.replace(".", ",");
