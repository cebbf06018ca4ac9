// Numbers in the sentences of a language.

/** To make a format takes hundreds of times as long as to use one. */
const formats = new Map<string, Intl.NumberFormat>();

/** A number with this many digits after the decimal point, as a language writes it. */
export function decimal(language: string, value: number, digits: number): string {
  const name = `${language} ${digits}`;
  const rounding = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  const format = formats.get(name) ?? new Intl.NumberFormat(language, rounding);
  formats.set(name, format);
  return format.format(value);
}

/** A number with a decimal point, written with the comma of German. */
export const withComma = (number: string): string => number.replace(".", ",");
