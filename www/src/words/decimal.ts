// Numbers in the sentences of a language.

/** A number with this many digits after the decimal point, as a language writes it. */
export function decimal(language: string, value: number, digits: number): string {
  const rounding = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return value.toLocaleString(language, rounding);
}
